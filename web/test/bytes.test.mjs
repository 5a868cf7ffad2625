import assert from 'node:assert/strict';
import {test} from 'node:test';
import {gzipSync} from 'node:zlib';
import {fromBase64, gunzip} from '../src/bytes.js';

test('base64 gives every byte back', () => {
  const bytes = Uint8Array.from({length: 256}, (_, i) => i);
  assert.deepEqual(fromBase64(Buffer.from(bytes).toString('base64')), bytes);
});

test('a gzip stream is unpacked', async () => {
  const bytes = Uint8Array.from({length: 100000}, (_, i) => i * i);
  assert.deepEqual(await gunzip(gzipSync(bytes)), bytes);
});

test('a stream that is cut off is refused', async () => {
  await assert.rejects(gunzip(gzipSync(new Uint8Array(1000)).subarray(0, 15)));
});
