import assert from 'node:assert/strict';
import {test} from 'node:test';
import {faultsAt, wordsOf} from '../src/event_words.js';

const words = (kind, detail, more = {}) => wordsOf({kind, detail, localizer: '', ...more});

test('kidnaps say what was done to the robot, and where it is', () => {
  const to = [1.234, -3.4];
  assert.equal(words('kidnap', 'teleport_to', {to}), 'kidnap: put at 1.2, -3.4');
  assert.equal(words('kidnap', 'carry', {to}), 'kidnap: carried to 1.2, -3.4');
  assert.equal(words('kidnap', 'splice', {to: null}), 'kidnap: the log goes on elsewhere');
  assert.equal(words('kidnap', 'by_storm', {to}), 'kidnap: by_storm');
});

test('faults, the world, people and orders have words', () => {
  assert.equal(words('fault on', 'lidar-blocked front'), 'fault: lidar covered (front)');
  assert.equal(words('fault off', 'odometry-frozen'), 'fault over: odometry frozen');
  assert.equal(words('world', 'box-1 put'), 'box-1 placed');
  assert.equal(words('world', 'gate open by 90 deg'), 'gate opened by 90°');
  assert.equal(words('world', '3 people came'), '3 people came');
  assert.equal(words('operator', 'off', {localizer: 'amcl'}), 'amcl is switched off');
  assert.equal(words('collision', ''), 'collision');
  assert.equal(words('collision', 'person 3'), 'collision with person 3');
  assert.equal(words('drive', '', {drive: {v: 0.2, w: -1}}), 'driven by hand: 0.2 m/s, -1 rad/s');
  assert.equal(words('drive', '', {drive: {}}), 'drives along its route again');
  assert.equal(words('quake', 'strong', {localizer: 'a'}), 'a quake (strong)');
});

test('faults are there from their beginning to their end', () => {
  const at = (time, kind, detail) => ({time, kind, detail});
  const events = [at(1, 'fault on', 'lidar-blocked'), at(2, 'fault on', 'lidar-blocked'), at(2.5, 'fault on', 'odometry-reset'),
    at(3, 'fault off', 'lidar-blocked'), at(3.5, 'fault on', 'odometry-frozen'), at(4, 'fault off', 'lidar-blocked')];
  const shown = (time) => faultsAt(events, time).join(', ');
  assert.deepEqual([0.9, 1, 2.6, 3.2, 3.6, 4].map(shown),
    ['', 'lidar covered', 'lidar covered', 'lidar covered', 'lidar covered, odometry frozen', 'odometry frozen']);
});
