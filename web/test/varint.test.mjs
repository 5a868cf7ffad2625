import assert from 'node:assert/strict';
import {test} from 'node:test';
import {Reader, column} from '../src/varint.js';

test('numbers are read as tools/base/bytes/varint.hpp writes them', () => {
  const reader = new Reader(Uint8Array.of(0, 1, 0x7f, 0x80, 1, 0xac, 2));
  assert.deepEqual([1, 2, 3, 4, 5].map(() => reader.next()), [0, 1, 127, 128, 300]);
  assert.ok(reader.done);
});

test('signed numbers', () => {
  const reader = new Reader(Uint8Array.of(0, 1, 2, 0x7f, 0x80, 1));
  assert.deepEqual([1, 2, 3, 4, 5].map(() => reader.nextSigned()), [0, -1, 1, -64, 64]);
});

test('large numbers lose nothing up to 2^50', () => {
  const reader = new Reader(Uint8Array.of(0x80, 0x80, 0x80, 0x80, 0x80, 0x80, 0x80, 4));
  assert.equal(reader.nextSigned(), 2 ** 50);
});

test('a column adds differences up', () => {
  assert.deepEqual(Array.from(column(Uint8Array.of(0xd0, 15, 2, 0, 3), 4, 0.5)), [500, 500.5, 500.5, 499.5]);
});

test('what ends within a number, or has too many, is refused', () => {
  assert.throws(() => new Reader(Uint8Array.of(0x80)).next(), RangeError);
  assert.throws(() => column(Uint8Array.of(2, 2, 2), 2), RangeError);
});
