import assert from 'node:assert/strict';
import {test} from 'node:test';
import {complete, isEmpty, seriesStyles, valueText} from '../src/plot_spec.js';

test('a plot without axes is one over time', () => {
  const plot = complete({title: 'Error', series: []}, [0, 1]);
  assert.deepEqual(plot, {x: {label: 'time [s]'}, y: {}, title: 'Error', series: [], shared: [0, 1]});
});

test('a plot keeps its own axes', () => {
  const {x, y} = complete({x: {label: 'driven [m]'}, y: {range: [0, 1]}, series: []}, undefined);
  assert.deepEqual([x, y], [{label: 'driven [m]'}, {range: [0, 1]}]);
});

test('a plot of references alone is empty', () => {
  const reference = {style: 'reference', y: [0, 1]};
  assert.ok(isEmpty({series: [reference, {y: []}]}));
  assert.ok(!isEmpty({series: [reference, {y: [1]}]}));
});

test('series have the styles of their localizers, their own, or those of their places', () => {
  const series = [{name: 'stated = right', style: 'reference'}, {name: 'amcl'}, {name: 'mh_amcl'}];
  assert.deepEqual(seriesStyles({series, localizers: true}), [-1, 1, 0]);
  assert.deepEqual(seriesStyles({series}), [-1, 0, 1]);
  assert.deepEqual(seriesStyles({series: [{name: 'quality', color: 1}, {name: 'covariance', color: 1}]}), [1, 1]);
});

test('small values have digits', () => {
  assert.deepEqual([0.00012345, 0.5, 12.345, 3, null].map(valueText), ['0.000123', '0.500', '12.35', '3', '\u2013']);
});
