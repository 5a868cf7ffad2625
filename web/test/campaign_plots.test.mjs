import assert from 'node:assert/strict';
import {test} from 'node:test';
import {curvesPlot, figureGroups, firstFigure} from '../src/campaign_plots.js';

const points = (series, y) => ({series, at: [0, 1], y, low: y.map((v) => v - 1), high: y.map((v) => v + 1), n: [2, 2]});
const data = {
  series: ['a', 'b', 'run'],
  styles: [3, 1, -1],
  names: ['distance_m', 'recovery.success'],
  units: ['m', '0 to 1'],
  axes: [
    {key: 'people.count', unit: '', numeric: true, labels: ['0', '3'], x: [0, 3],
      figures: [[points(2, [5, 6])], [points(1, [1, 2])]]},
    {key: 'kind', unit: 's', numeric: false, labels: ['carry', 'push'], x: [0, 1],
      figures: [[points(2, [5, 6])], [points(0, [1, 2]), points(1, [2, 3])]]},
  ],
};

test('a localizer without the figure keeps its place and colour', () => {
  const {title, series, y} = curvesPlot(data, data.axes[0], 1);
  assert.equal(title, 'recovery.success over people.count');
  assert.deepEqual(series.map(({name, x}) => [name, x]), [['a', []], ['b', [0, 3]]]);
  assert.deepEqual(series.map(({color}) => color), [3, 1]);
  assert.deepEqual(y, {label: 'recovery.success [0 to 1]', range: [0, 1]});
});

test('a figure of the run is one series, whose intervals are within the axis', () => {
  const {series, y} = curvesPlot(data, data.axes[0], 0);
  assert.deepEqual(series.map(({name}) => name), ['run']);
  assert.ok(y.least > 7);
  assert.equal(y.label, 'distance_m [m]');
});

test('values that are no numbers are dots with names, beside each other', () => {
  const {x, series} = curvesPlot(data, data.axes[1], 1);
  assert.equal(x.label, 'kind [s]');
  assert.deepEqual(x.names, ['carry', 'push']);
  assert.deepEqual(x.range, [-0.5, 1.5]);
  assert.deepEqual(series.map(({style}) => style), ['points', 'points']);
  assert.ok(series[0].x[0] < 0 && series[1].x[0] > 0);
});

test('the share of recovered kidnaps comes first', () => {
  assert.equal(firstFigure(data.names), 1);
  assert.equal(firstFigure(['cpu']), 0);
});

test('figures come sorted, behind those that are asked for most', () => {
  assert.deepEqual(figureGroups(['tracking_error_m.mean', 'b', 'a', 'recovery.success']), [
    ['most asked for', ['recovery.success', 'tracking_error_m.mean']],
    ['all', ['a', 'b', 'recovery.success', 'tracking_error_m.mean']]]);
  assert.deepEqual(figureGroups(['b', 'a']), [['all', ['a', 'b']]]);
});
