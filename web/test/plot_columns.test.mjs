import assert from 'node:assert/strict';
import {test} from 'node:test';
import {align, clip, logRange, powersOfTen, rangeFromZero, tickTexts} from '../src/plot_columns.js';

test('series that share their x are taken as they are', () => {
  assert.deepEqual(align([{y: [1, null]}, {y: [3, 4]}], [0, 1]), [[0, 1], [1, null], [3, 4]]);
});

test('series of their own x are put in one order, without gaps', () => {
  const nothing = undefined;
  assert.deepEqual(align([{x: [2, 0], y: [5, 6]}, {x: [1, 1], y: [7, null]}]),
    [[0, 1, 1, 2], [6, nothing, nothing, 5], [nothing, 7, null, nothing]]);
});

test('points of several series at one x stand in one row', () => {
  assert.deepEqual(align([{x: [0, 1, 1], y: [1, 2, 3]}, {x: [0, 1], y: [4, 5]}]),
    [[0, 1, 1], [1, 2, 3], [4, undefined, 5]]);
});

test('a series of its own x stands beside one that shares', () => {
  assert.deepEqual(align([{y: [1, 2]}, {x: [1], y: [9]}], [0, 2]),
    [[0, 1, 2], [1, undefined, 2], [undefined, 9, undefined]]);
});

test('values are clipped to their axis, gaps stay', () => {
  assert.deepEqual(clip([0, 0.5, 20, null, undefined], [0.01, 10]), [0.01, 0.5, 10, null, undefined]);
});

test('a log axis narrows to its values, but holds 0.1 to 1', () => {
  assert.deepEqual(logRange([[0.02, null, 30], [undefined]], [0.001, 100]), [0.01, 100]);
  assert.deepEqual(logRange([[]], [0.001, 100]), [0.1, 1]);
  assert.deepEqual(logRange([[0.0001]], [0.001, 100]), [0.001, 1]);
});

test('ticks of a log axis are the powers of ten', () => {
  assert.deepEqual(powersOfTen(0.001, 1), [0.001, 0.01, 0.1, 1]);
  assert.deepEqual(powersOfTen(0.1, 180), [0.1, 1, 10, 100]);
});

test('an axis without limits goes from zero to above its values', () => {
  assert.deepEqual(rangeFromZero([[1, null, 20], [undefined, 2]], 4), [0, 21]);
  assert.deepEqual(rangeFromZero([[1, null]], 4), [0, 4]);
  assert.deepEqual(rangeFromZero([[]], 0), [0, 1]);
});

test('ticks differ however near they are', () => {
  assert.deepEqual(tickTexts([0, 0.0001, 0.0002]), ['0.0000', '0.0001', '0.0002']);
  assert.deepEqual(tickTexts([0, 0.25, 0.5]), ['0.00', '0.25', '0.50']);
  assert.deepEqual(tickTexts([0, 20, 40, null]), ['0', '20', '40', '']);
  assert.deepEqual(tickTexts([-0.1, 0, 0.1]), ['-0.1', '0.0', '0.1']);
});
