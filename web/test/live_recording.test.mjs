import assert from 'node:assert/strict';
import {test} from 'node:test';
import {peopleOf} from '../src/details.js';
import {readFrame} from '../src/live_frame.js';
import {LiveRecording} from '../src/live_recording.js';

const hello = {localizers: ['a', 'b'], map: {width: 1, height: 1}, robot_radius_m: 0.2, cells: btoa('\x01\x01'),
  steps: {point: 0.01, angle: 0.01}};

const scan = (time, answer = [1, 2, 0.5, 0, 0.9, 0.8, 0.01, 0.02]) =>
  [time, 0, [time, 0, 0], [{answer, populations: 1, particles: 9}, {answer: null, populations: 0, particles: 0}]];

const frame = (scans, blocks = [], first = 0) => ({now: 0, first, scans, lidars: [{name: 'lidar'}], blocks});

/** A recording of scans at these times, each in a frame of its own with beams. */
function recordingOf(...times) {
  const recording = new LiveRecording(hello);
  times.forEach((time, i) => recording.add(frame([scan(time)], [new Uint8Array([i])], i)));
  return recording;
}

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

test('what the run went back over is left out', () => {
  const recording = recordingOf(1, 2, 3, 4, 5);
  recording.add({first: 3, scans: []});
  assert.deepEqual(recording.time, [1, 2, 3]);
  assert.equal(recording.localizers[0].x.length, 3);
  assert.equal(recording.details.length, 3);
  recording.add(frame([scan(3.5)], [], 3));
  assert.deepEqual(recording.time, [1, 2, 3, 3.5]);
});

test('what is told again takes the place of what was there; what is the same keeps its beams', () => {
  const recording = recordingOf(1, 2, 3, 4, 5);
  recording.add({first: 1, scans: [scan(2), scan(3)]});
  assert.deepEqual(recording.time, [1, 2, 3]);
  assert.deepEqual(recording.details.map((detail) => [detail.scan, ...detail.blocks[0]]), [[0, 0], [1, 1], [2, 2]]);
  const other = scan(2, [9, 2, 0.5, 0, 0.9, 0.8, 0.01, 0.02]);
  recording.add({first: 1, scans: [other, scan(3)]});
  assert.deepEqual(recording.time, [1, 2, 3]);
  assert.deepEqual(recording.localizers[0].x, [1, 9, 1]);
  assert.deepEqual(recording.errors[0].position.map(Math.round), [2, 7, 3]);
  assert.deepEqual(recording.details.map((detail) => detail.scan), [0]);
});

test('a history that is told twice is there once', () => {
  const recording = recordingOf(1, 2);
  const history = {first: 0, scans: [scan(1), scan(2), scan(3)]};
  recording.add(history);
  recording.add(history);
  assert.deepEqual(recording.time, [1, 2, 3]);
});

test('scans that were missed come later, where a page did not read', () => {
  const recording = recordingOf(1);
  recording.add(frame([scan(4)], [], 3));
  assert.deepEqual(recording.time, [1, 4]);
  recording.add({first: 0, scans: [scan(1), scan(2), scan(3), scan(4)]});
  assert.deepEqual(recording.time, [1, 2, 3, 4]);
});

test('scans of several lidars are in the order of their times', () => {
  const recording = recordingOf(1, 1.2, 1.1, 1.2, 1.3);
  assert.deepEqual(recording.time, [1, 1.1, 1.2, 1.2, 1.3]);
  assert.deepEqual(recording.truth.x, [1, 1.1, 1.2, 1.2, 1.3]);
  assert.deepEqual(recording.details.map((detail) => [detail.scan, ...detail.blocks[0]]), [[0, 0], [1, 2], [2, 1], [3, 3], [4, 4]]);
  recording.add({first: 2, scans: []});
  assert.deepEqual(recording.time, [1, 1.2]);
  assert.deepEqual(recording.details.map((detail) => detail.scan), [0, 1]);
});

test('changes of the world go with their events', () => {
  const recording = new LiveRecording(hello);
  const event = (number, change) => ({number, change});
  assert.equal(recording.takeChanges(0, [event(0)]), false);
  recording.takeChanges(0, [event(0, {time: 1, name: 'box'}), event(1), event(2, {time: 2, name: 'gate'})]);
  assert.deepEqual(recording.changes.map(({name}) => name), ['box', 'gate']);
  assert.equal(recording.takeChanges(1, []), true);
  assert.deepEqual(recording.changes.map(({name}) => name), ['box']);
});

test('memory is bounded', () => {
  const recording = new LiveRecording(hello);
  for (let i = 0; i < 40000; ++i) recording.add(frame([scan(i / 10)], [new Uint8Array([0])], i));
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
