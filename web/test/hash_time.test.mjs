import assert from 'node:assert/strict';
import {test} from 'node:test';
import {hashTime, openingTime} from '../src/hash_time.js';

test('an address may ask for a moment', () => {
  assert.deepEqual(['#t=12.3', '#t=0', '', '#t=', '#t=-1', '#t=1e9', '#events'].map(hashTime),
    [12.3, 0, null, null, null, null, null]);
});

test('the player opens at the first scan from the event on', () => {
  assert.equal(openingTime(3, [1, 2.9, 3, 3.1]), 3);
  assert.equal(openingTime(2.95, [1, 2.9, 3, 3.1]), 3);
  assert.equal(openingTime(null, [1, 2]), null);
  assert.equal(openingTime(9, [1, 2]), null);
});
