import assert from 'node:assert/strict';
import {test} from 'node:test';
import {hashTime} from '../src/hash_time.js';

test('an address may ask for a moment', () => {
  assert.deepEqual(['#t=12.3', '#t=0', '', '#t=', '#t=-1', '#t=1e9', '#events'].map(hashTime),
    [12.3, 0, null, null, null, null, null]);
});
