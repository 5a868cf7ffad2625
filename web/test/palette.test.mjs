import assert from 'node:assert/strict';
import {test} from 'node:test';
import {mapPixels} from '../src/map_image.js';
import {pick, rgb} from '../src/palette.js';

test('colours go round', () => {
  assert.deepEqual([-1, 0, 3, 4].map((i) => pick(['a', 'b', 'c'], i)), ['c', 'a', 'a', 'b']);
});

test('colours are read in both lengths', () => {
  assert.deepEqual(rgb('#0072B2'), [0, 114, 178]);
  assert.deepEqual(rgb('#fff'), [255, 255, 255]);
});

test('a map has its first row at the bottom', () => {
  const colors = {free: '#ffffff', wall: '#000000', unknown: '#808080'};
  // 3 x 2 cells: 0, 0, unknown; unknown, 100, 60
  const pixels = mapPixels(Uint8Array.of(1, 2, 0, 2, 101, 1, 61, 1), {width: 3, height: 2}, colors);
  const grey = Array.from(pixels).filter((_, i) => i % 4 === 0);
  assert.deepEqual(grey, [128, 0, 102, 255, 255, 128]);
});
