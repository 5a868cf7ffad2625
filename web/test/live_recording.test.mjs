import assert from 'node:assert/strict';
import {test} from 'node:test';
import {peopleOf} from '../src/details.js';
import {readFrame} from '../src/live_frame.js';
import {LiveRecording} from '../src/live_recording.js';

const hello = {localizers: ['a', 'b'], map: {width: 1, height: 1}, robot_radius_m: 0.2, cells: btoa('\x01\x01'),
  steps: {point: 0.01, angle: 0.01}};

const scan = (time, answer = [1, 2, 0.5, 0, 0.9, 0.8, 0.01, 0.02]) =>
  [time, 0, [time, 0, 0], [{answer, populations: 1, particles: 9}, {answer: null, populations: 0, particles: 0}]];

const frame = (scans, blocks = []) => ({now: 0, scans, lidars: [{name: 'lidar'}], blocks});

test('a frame is JSON and blocks of bytes', () => {
  const text = new TextEncoder().encode(JSON.stringify({now: 2, scans: [], blocks: [2, 1]}));
  const bytes = new Uint8Array(4 + text.length + 3);
  new DataView(bytes.buffer).setUint32(0, text.length, true);
  bytes.set(text, 4);
  bytes.set([7, 8, 9], 4 + text.length);
  const read = readFrame(bytes.buffer);
  assert.equal(read.now, 2);
  assert.deepEqual(read.blocks.map((block) => [...block]), [[7, 8], [9]]);
});

test('scans are added with what each localizer answered', () => {
  const recording = new LiveRecording(hello);
  recording.add(frame([scan(1), scan(1.1, [3, 4, 0, 1, null, 0.2, 0, 0])]));
  assert.equal(recording.scans, 2);
  assert.deepEqual(recording.truth.x, [1, 1.1]);
  const [a, b] = recording.localizers;
  assert.deepEqual(a.known, [1, 1]);
  assert.deepEqual(a.lost, [0, 1]);
  assert.deepEqual(a.quality, [0.9, -1]);
  assert.deepEqual(b.known, [0, 0]);
  assert.equal(recording.header.lidars[0].name, 'lidar');
  assert.deepEqual([0, 1, 1.05, 9].map((time) => recording.scanAt(time)), [0, 0, 0, 1]);
});

test('the newest scan of a frame has details', () => {
  const recording = new LiveRecording(hello);
  recording.add(frame([scan(1), scan(2)], [new Uint8Array([0]), new Uint8Array([1, 0, 200, 1, 0, 0]),
    new Uint8Array([0]), new Uint8Array([0])]));
  assert.equal(recording.detailAt(0), -1);
  const at = recording.detailAt(1);
  assert.equal(recording.details[at].scan, 1);
  assert.deepEqual(peopleOf(recording, at).map(({x}) => x), [1]);
});

test('what the run went back over is cut', () => {
  const recording = new LiveRecording(hello);
  for (let i = 1; i <= 5; ++i) recording.add(frame([scan(i)], [new Uint8Array([0])]));
  recording.cut(3);
  assert.deepEqual(recording.time, [1, 2, 3]);
  assert.equal(recording.localizers[0].x.length, 3);
  assert.equal(recording.details.length, 3);
});

test('memory is bounded', () => {
  const recording = new LiveRecording(hello);
  for (let i = 0; i < 40000; ++i) recording.add(frame([scan(i / 10)], [new Uint8Array([0])]));
  assert.ok(recording.scans <= 18000);
  assert.equal(recording.time.at(-1), 3999.9);
  assert.equal(recording.details.at(-1).scan, recording.scans - 1);
  assert.ok(recording.columns().every((column) => column.length === recording.scans));
});

test('on several floors, heights are added', () => {
  const recording = new LiveRecording({...hello, heights: true,
    levels: {map: {width: 1, height: 1}, z_m: [0, 3], cells: [btoa('\x01\x01'), btoa('\x65\x01')]}});
  const row = scan(1, [1, 0, 0, 0, 0.9, 0.8, 0.01, 0.02, 3]);
  row[2] = [1, 0, 0, 3, 0.1, 0.2];
  recording.add(frame([row]));
  assert.deepEqual([recording.truth.z, recording.truth.pitch, recording.localizers[0].z, recording.localizers[1].z], [[3], [0.2], [3], [0]]);
  assert.equal(recording.errors[0].position[0], 0);
  assert.deepEqual([...recording.sections.get('level/1')], [0x65, 1]);
});
