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
