import assert from 'node:assert/strict';
import {test} from 'node:test';
import {commandOf} from '../src/live_drive.js';
import {faultEvent} from '../src/live_tools.js';

test('keys add up', () => {
  assert.equal(commandOf(new Set()), null);
  assert.deepEqual(commandOf(new Set(['w'])), {v: 0.26, w: 0});
  assert.deepEqual(commandOf(new Set(['w', 'a'])), {v: 0.26, w: 1.2});
  assert.equal(commandOf(new Set(['w', 's'])), null);
});

test('a stick at rest commands nothing', () => {
  assert.equal(commandOf(new Set(), {axes: [0.1, -0.1]}), null);
  assert.deepEqual(commandOf(new Set(), {axes: [0.5, -1]}), {v: 0.26, w: -0.6});
});

test('a fault lasts, a reset does not', () => {
  assert.deepEqual(faultEvent('no scans', 3), {fault: {kind: 'lidar-dropout', for_s: 3}});
  assert.deepEqual(faultEvent('odometry reset', 3), {fault: {kind: 'odometry-reset'}});
});
