import assert from 'node:assert/strict';
import {test} from 'node:test';
import {pathData, plotsSvg} from '../src/plot_svg.js';

test('a path begins anew behind a gap, and skips what has no value', () => {
  assert.equal(pathData([0, 1, 2, 3, 4], [1, 2, null, 4, undefined], (x, y) => [10 * x, y]), 'M0.0 1.0L10.0 2.0M30.0 4.0');
});

test('plots are saved as lines with ticks, marks and names', () => {
  globalThis.devicePixelRatio = 2;
  const axis = (splits) => ({_splits: splits, _values: splits.map(String), label: 'time [s]'});
  const plot = {
    width: 120, height: 100, bbox: {left: 40, top: 20, width: 200, height: 120}, axes: [axis([0, 10]), axis([0, 5])],
    data: [[0, 10], [0, 5], [5, null]], valToPos: (value, scale) => (scale === 'x' ? 10 * value : 60 - 12 * value),
  };
  const colors = {localizers: ['#111', '#222', '#333', '#444', '#555', '#666'], ink: 'black', soft: 'grey', line: 'silver',
    page: 'white', mark: 'purple'};
  const svg = plotsSvg([{plot, title: 'Error', unit: 'm', styles: [0, 1], marks: [{time: 5, color: 'mark'}], limit: 1}],
    ['<a>', 'b'], colors);
  assert.ok(svg.includes('>Error [m]</text>'));
  assert.ok(svg.includes('<path d="M20.0 70.0L120.0 10.0" fill="none" stroke="#111"'));
  assert.ok(svg.includes('<path d="M20.0 10.0" fill="none" stroke="#222" stroke-width="1.6" stroke-dasharray="8 4"/>'));
  assert.ok(svg.includes('<path d="M70.0 10.0L70.0 70.0" stroke="purple"'));
  assert.ok(svg.includes('<path d="M20.0 58.0L120.0 58.0" stroke="grey"'));
  assert.ok(svg.includes('>&#60;a&#62;</text>'));
  assert.ok(svg.includes('viewBox="0 0 120 144"'));
});
