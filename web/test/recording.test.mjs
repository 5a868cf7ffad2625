import assert from 'node:assert/strict';
import {test} from 'node:test';
import {beamEnds, beamsOf, peopleOf, populationsOf} from '../src/details.js';
import {Recording} from '../src/recording.js';
import {fixture, near} from './fixture.mjs';

const recording = new Recording(fixture());

test('scans stand in order of time, however they were delivered', () => {
  assert.ok(near(recording.time, [0, 1, 2]));
  assert.ok(near(recording.truth.x, [0, 0.1, 0.2]));
  assert.deepEqual(Array.from(recording.torn), [0, 1, 0]);
});

test('names are taken as they are', () => {
  assert.deepEqual(recording.names, ['a', '</script>"b"']);
});

test('poses and beliefs of localizers', () => {
  const [a, b] = recording.localizers;
  assert.ok(near(a.y, [0.2, 0.2, 0.2]));
  assert.ok(near(a.yaw, [0.1, 0.1, 0.1]));
  assert.ok(near(a.quality, [0.75, 0.75, 0.75]));
  assert.ok(near(a.probability, [0.5, 0.5, 0.5]));
  assert.deepEqual(Array.from(b.known), [0, 1, 1]);
  assert.deepEqual(Array.from(b.lost), [0, 0, 1]);
  assert.deepEqual(Array.from(a.populations), [1, 1, 1]);
  assert.deepEqual(Array.from(a.particles), [2, 2, 2]);
});

test('the newest scan at a time', () => {
  assert.deepEqual([-1, 0, 0.99, 1, 1.5, 7].map((t) => recording.scanAt(t)), [0, 0, 0, 1, 1, 2]);
});

test('the details of a scan', () => {
  const at = recording.detailAt(1);
  assert.equal(recording.details[at].scan, 1);
  const {lidar, ranges} = beamsOf(recording, at);
  assert.equal(lidar, 0);
  assert.equal(ranges.length, 3);
  assert.ok(near([ranges[0], ranges[2]], [1, 2.5]) && Number.isNaN(ranges[1]));
  assert.deepEqual(peopleOf(recording, at), [{id: 7, x: -1, y: 2.5, yaw: 1}]);
  assert.deepEqual(peopleOf(recording, recording.detailAt(0)), []);
});

test('beams end where the lidar sees them', () => {
  const ends = beamEnds(recording.header.lidars[0], [1, NaN, 2.5]);
  assert.ok(near(ends, [1.1, 0, 0.1 + 2.5 * Math.cos(3), 2.5 * Math.sin(3)]));
});

test('populations and their particles', () => {
  const [population, ...more] = populationsOf(recording, 0, 1);
  assert.equal(more.length, 0);
  const {points, ...rest} = population;
  assert.deepEqual(rest, {id: 4, selected: true, share: 0.75, quality: 0.25, x: 1, y: 2, yaw: 0.5});
  assert.ok(near(points, [0.9, 1.97, 1.1, 2]));
  assert.deepEqual(populationsOf(recording, 1, 1), []);
});

test('another version is refused', () => {
  const bytes = fixture();
  bytes[19] = '2'.charCodeAt(0);
  assert.throws(() => new Recording(bytes), /another version/);
});
