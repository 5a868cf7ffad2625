import assert from 'node:assert/strict';
import {test} from 'node:test';
import {complete, isEmpty} from '../src/plot_spec.js';

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
