import assert from 'node:assert/strict';
import {test} from 'node:test';
import {clockText, readable} from '../src/dom.js';

test('times are told in seconds, long ones in minutes', () => {
  assert.equal(clockText(83.14), '83.1 s');
  assert.equal(clockText(605.04), '10:05.0');
});

test('figures have three digits and a unit', () => {
  assert.deepEqual([0.01234, 1.234, 12.34, 123.4].map((v) => readable(v, 'm')),
    ['0.012 m', '1.23 m', '12.3 m', '123 m']);
  assert.equal(readable(null, 'm'), '–');
});
