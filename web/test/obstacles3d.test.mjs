import assert from 'node:assert/strict';
import {test} from 'node:test';
import {freeDistance, occupiedCells} from '../src/view3d/obstacles.js';

// 4 x 2 cells of 0.5 m; the right column is a wall: pairs of value + 1 and count, as in recordings.
const map = {width: 4, height: 2, resolution_m: 0.5, origin: [1, 1, 0]};
const cells = occupiedCells(new Uint8Array([1, 3, 101, 1, 0, 3, 101, 1]), map);

test('walls are obstacles, unknown cells are not', () => {
  assert.deepEqual([...cells], [0, 0, 0, 1, 0, 0, 0, 1]);
});

test('the way to a wall ends at it, and elsewhere at its limit', () => {
  const from = {x: 1.25, y: 1.25};
  const way = freeDistance(map, cells, from, 0, 9);
  assert.ok(way > 1 && way <= 1.75, `${way}`);
  assert.equal(freeDistance(map, cells, from, Math.PI, 9), 9);
  assert.equal(freeDistance(map, cells, from, 0, 0.5), 0.5);
});

test('a turned map is turned', () => {
  const turned = {...map, origin: [1, 1, Math.PI / 2]};
  const way = freeDistance(turned, cells, {x: 0.75, y: 1.25}, Math.PI / 2, 9);
  assert.ok(way > 1 && way <= 1.75, `${way}`);
});
