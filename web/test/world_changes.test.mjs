import assert from 'node:assert/strict';
import {test} from 'node:test';
import {changesSoFar, distanceTo, isIn, isOpen, nearest, worldAt} from '../src/world_changes.js';

const square = (x, y) => [[x, y], [x + 1, y], [x + 1, y + 1], [x, y + 1]];
const change = (time, name, outline) => ({time, name, outline, z: [0, 1]});
const door = {name: 'D', outline: square(5, 0), closed: square(9, 0), z: [0, 2]};

test('objects come and go', () => {
  const changes = [change(1, 'A', square(0, 0)), change(2, 'B', square(3, 0)), change(3, 'A', [])];
  const names = (time) => [...worldAt({}, changes, time).keys()];
  assert.deepEqual(names(0.5), []);
  assert.deepEqual(names(1), ['A']);
  assert.deepEqual(names(2.5), ['A', 'B']);
  assert.deepEqual(names(9), ['B']);
});

test('changes of an object are counted', () => {
  const changes = [change(1, 'A', square(0, 0)), change(2, 'B', square(3, 0)), change(3, 'A', [])];
  assert.deepEqual([0, 1, 2, 3].map((time) => changesSoFar(changes, 'A', time)), [0, 1, 1, 2]);
  assert.equal(changesSoFar(changes, 'C', 9), 0);
});

test('doors are there from the beginning, and stay doors', () => {
  const changes = [change(2, 'D', square(9, 0))];
  const before = worldAt({doors: [door]}, changes, 1).get('D');
  const after = worldAt({doors: [door]}, changes, 2).get('D');
  assert.deepEqual([before.door, isOpen(before)], [true, true]);
  assert.deepEqual([after.door, isOpen(after)], [true, false]);
  assert.deepEqual(after.outline, square(9, 0));
});

test('a point is in an outline, or at a distance', () => {
  assert.ok(isIn(square(0, 0), [0.5, 0.5]));
  assert.ok(!isIn(square(0, 0), [1.5, 0.5]));
  assert.equal(distanceTo(square(0, 0), [0.2, 0.9]), 0);
  assert.equal(distanceTo(square(0, 0), [0.5, -2]), 2);
  assert.equal(distanceTo(square(0, 0), [4, 5]), 5);
});

test('the nearest thing within reach is touched', () => {
  const things = worldAt({doors: [door]}, [change(0, 'A', square(0, 0))], 1);
  assert.equal(nearest(things, [1.2, 0.5], 0.5), 'A');
  assert.equal(nearest(things, [4.8, 0.5], 0.5), 'D');
  assert.equal(nearest(things, [3, 0.5], 0.5), null);
});
