import assert from 'node:assert/strict';
import {test} from 'node:test';
import {aheadEvent, faultEvent} from '../src/live_tools.js';

test('a fault has its duration, but for a reset, which takes no time', () => {
  assert.deepEqual(faultEvent('odometry frozen', 7), {fault: {kind: 'odometry-frozen', for_s: 7}});
  assert.deepEqual(faultEvent('lidar half covered', 2), {fault: {kind: 'lidar-blocked', from_deg: 0, to_deg: 180, for_s: 2}});
  assert.deepEqual(faultEvent('odometry reset', 7), {fault: {kind: 'odometry-reset'}});
});

test('things are put before the robot, and look where it looks', () => {
  const robot = {x: 1, y: 2, yaw: Math.PI / 2};
  assert.deepEqual(aheadEvent('box', robot, {}), {box: {at: [1, 3.2], yaw_deg: 90, size: [0.6, 0.4, 0.6]}});
  assert.deepEqual(aheadEvent('person', {x: 0, y: 0, yaw: 0}, {people: {count: 3, walk: true}}),
    {people: {at: [1.2, 0], yaw_deg: 0, count: 3, walk: true}});
});
