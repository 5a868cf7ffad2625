import assert from 'node:assert/strict';
import {test} from 'node:test';
import {errorPieces, errorStep, kErrorWords} from '../src/error_scale.js';

test('errors have six steps, and none has none', () => {
  assert.deepEqual([0, 0.0999, 0.1, 0.49, 0.5, 0.99, 1, 4.9, 5, 99].map(errorStep), [0, 0, 1, 2, 3, 3, 4, 4, 5, 5]);
  assert.equal(errorStep(null), -1);
  assert.equal(kErrorWords.length, 6);
  assert.deepEqual([kErrorWords[0], kErrorWords[3], kErrorWords[5]], ['below 0.1', '0.5 to 1', 'from 5']);
});

test('a path falls into pieces of one colour that join', () => {
  const pieces = errorPieces([[0, 0, 1, 0, 2, 0, 3, 0]], [[0, 0, 0, 2]]);
  assert.deepEqual(pieces, [{step: 0, points: [0, 0, 1, 0, 2, 0]}, {step: 4, points: [2, 0, 3, 0]}]);
});

test('a jump is no piece', () => {
  const pieces = errorPieces([[0, 0, 1, 0], [9, 9, 9, 8], [5, 5]], [[0, 0], [0, null], [0]]);
  assert.deepEqual(pieces, [{step: 0, points: [0, 0, 1, 0]}, {step: -1, points: [9, 9, 9, 8]}]);
});
