import assert from 'node:assert/strict';
import {test} from 'node:test';
import {radiiOf} from '../src/plot_marks.js';

test('dots are seen however small their weight, and their areas grow with it', () => {
  assert.deepEqual(radiiOf([0, 100]), [4, 10]);
  assert.deepEqual(radiiOf([25, 100]), [7, 10]);
  assert.deepEqual(radiiOf([3]), [10]);
  assert.deepEqual(radiiOf([]), []);
});
