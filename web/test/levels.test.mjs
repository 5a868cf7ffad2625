import assert from 'node:assert/strict';
import {test} from 'node:test';
import {populationsOf} from '../src/details.js';
import {floorOf, levelAt} from '../src/levels.js';
import {mapPixels} from '../src/map_image.js';
import {errorsOf} from '../src/measures.js';
import {Recording} from '../src/recording.js';
import {fixture, near} from './fixture.mjs';

const recording = new Recording(fixture('levels'));

test('a height belongs to the floor below it', () => {
  assert.deepEqual([-1, 0, 2.4, 2.6, 3, 99].map((z) => levelAt([0, 3, 6], z)), [0, 0, 0, 1, 1, 2]);
});

test('truth and answers have heights', () => {
  assert.ok(near(recording.truth.z, [0, 1.5, 3]));
  assert.ok(near(recording.truth.pitch, [0.125, 0.125, 0.125]));
  assert.ok(near(recording.localizers[0].z, [0, 1.5, 3]));
  assert.ok(near(recording.localizers[1].z, [0, 0, 0]));
  assert.equal(new Recording(fixture()).truth.z, undefined);
});

test('populations have heights, and what follows is read as before', () => {
  const [population] = populationsOf(recording, 0, recording.detailAt(1));
  assert.ok(near([population.z], [3]));
  assert.ok(near(population.points, [0.9, 1.97, 1.1, 2]));
});

test('errors are those in space', () => {
  const [right, planar] = recording.localizers.map((localizer) => errorsOf(recording, localizer).position);
  assert.ok(near([right[2], planar[2]], [0.2, Math.hypot(0.2, 3)]));
});

test('a truth without heights is planar', () => {
  const {z, roll, pitch, ...truth} = recording.truth;
  assert.ok(near(errorsOf({scans: 3, torn: [0, 0, 0], truth}, recording.localizers[0]).position, [0.2, 0.2, 0.2]));
});

test('the floor of the robot is seen, or the one that is chosen', () => {
  const of = (scan, more = {}) => floorOf({level: -1, ...more}, recording, scan);
  assert.deepEqual([0, 1, 2].map((scan) => of(scan).level), [0, 0, 1]);
  assert.equal(of(0, {level: 1}).section, 'level/1');
  assert.equal(of(0, {live: {lift: [3.1, 0, 0]}}).level, 1);
  assert.deepEqual([0, 3, undefined].map((z) => of(2).onLevel(z)), [false, true, false]);
  assert.ok(near([of(1).ceiling, of(1, {level: 1}).ceiling], [3.4, 4.9]));
});

test('a planar run is on one floor', () => {
  const floor = floorOf({level: -1}, new Recording(fixture()), 1);
  assert.equal(floor.section, 'map');
  assert.ok(floor.onLevel(undefined) && floor.ceiling === Infinity);
});

test('floors have their own cells', () => {
  const colors = {free: '#ffffff', wall: '#000000', unknown: '#808080'};
  const pixels = (section) => mapPixels(recording.sections.get(section), recording.header.levels.map, colors);
  assert.deepEqual([...pixels('level/1')].filter((value) => value !== 255), []);
  assert.notDeepEqual(pixels('level/0'), pixels('level/1'));
});
