import assert from 'node:assert/strict';
import {test} from 'node:test';
import {mapPixels} from '../src/map_image.js';
import {pick, rgb, shade, styleOf, stylesOf} from '../src/palette.js';

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

test('a localizer looks the same in every run', () => {
  assert.deepEqual(stylesOf(['mh_amcl', 'amcl']), [0, 1]);
  assert.deepEqual(stylesOf(['amcl', 'mh_amcl']), [1, 0]);
  assert.deepEqual(stylesOf(['amcl', 'mine', 'mh_amcl']), [1, ...stylesOf(['mine']), 0]);
  const names = ['amcl', 'mine'];
  assert.deepEqual(names.map((_, k) => styleOf(names, k)), stylesOf(names));
});

// tests/tools/outputs/pictures/localizer_styles_test.cpp has the same table.
test('styles are those of the pictures', () => {
  assert.deepEqual(stylesOf(['mine']), [4]);
  assert.deepEqual(stylesOf(['a', 'b', 'c']), [2, 3, 4]);
  assert.deepEqual(stylesOf(['gr\u00fc n']), [3]);
  assert.deepEqual(stylesOf(['constructor']).length, 1);
});

test('names that would share a style take a free one', () => {
  assert.deepEqual(stylesOf(['amcl', 'amcl']), [1, 2]);
  assert.deepEqual(stylesOf(['mine', 'mine', 'mine']), [4, 5, 2]);
  const all = stylesOf(['a', 'b', 'c', 'd', 'e', 'f', 'a']);
  assert.equal(new Set(all.slice(0, 6)).size, 6);
  assert.ok(all[6] >= 0 && all[6] < 6);
});

test('populations are shades of their localizer', () => {
  assert.equal(shade('#0072b2', 0), '#0072b2');
  assert.equal(shade('#0072b2', 3), '#0072b2');
  assert.equal(shade('#0072b2', 1), '#00476e');
  assert.equal(shade('#0072b2', 2), '#73b1d5');
  assert.equal(shade('#0072b2', -1), '#73b1d5');
});
