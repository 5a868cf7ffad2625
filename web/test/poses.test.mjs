import assert from 'node:assert/strict';
import {test} from 'node:test';
import {pieces, poseAt} from '../src/poses.js';
import {near} from './fixture.mjs';

const track = {
  known: [1, 1, 0, 1, 1], x: [0, 0.2, 0, 1, 5], y: [0, 0, 0, 1, 5], yaw: [3.1, -3.1, 0, 0, 0],
};
const times = [0, 0.1, 0.2, 0.3, 0.4];

test('poses between scans lie between them, the short way round', () => {
  const pose = poseAt(track, times, 0, 0.05);
  assert.ok(near([pose.x, pose.y], [0.1, 0]));
  assert.ok(Math.abs(Math.abs(pose.yaw) - Math.PI) < 1e-6);
});

test('nothing moves along a jump, nor to where nothing is known', () => {
  assert.deepEqual(poseAt(track, times, 3, 0.35), {x: 1, y: 1, yaw: 0});
  assert.deepEqual(poseAt(track, times, 1, 0.15), {x: 0.2, y: 0, yaw: -3.1});
  assert.equal(poseAt(track, times, 2, 0.25), null);
  assert.deepEqual(poseAt(track, times, 4, 9), {x: 5, y: 5, yaw: 0});
});

test('ways are cut at jumps and gaps', () => {
  assert.deepEqual(pieces(track, 0, 4), [[0, 0, 0.2, 0], [1, 1], [5, 5]]);
});

const rising = {known: [1, 1, 1, 1], x: [0, 0.2, 0.4, 0.4], y: [0, 0, 0, 0], yaw: [0, 0, 0, 0], z: [0, 0.1, 0.2, 3],
  roll: [0, 0, 0, 0], pitch: [0, 0.2, 0.2, 0]};

test('on several floors, poses have heights and tilts', () => {
  const pose = poseAt(rising, times, 0, 0.05);
  assert.ok(near([pose.z, ...pose.lift], [0.05, 0.05, 0, 0.1]));
  assert.equal(poseAt(rising, times, 2, 0.25).z, 0.2);  // A lift goes up: nothing moves along a jump.
});

test('ways are cut where they leave a floor, and at jumps in height', () => {
  const heights = [];
  assert.deepEqual(pieces(rising, 0, 3, undefined, heights), [[0, 0, 0.2, 0, 0.4, 0], [0.4, 0]]);
  assert.deepEqual(heights, [[0, 0.1, 0.2], [3]]);
  assert.deepEqual(pieces(rising, 0, 3, (z) => z < 1 && z > 0.05), [[0.2, 0, 0.4, 0]]);
});
