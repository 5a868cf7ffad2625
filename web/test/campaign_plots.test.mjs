import assert from 'node:assert/strict';
import {test} from 'node:test';
import {curvesPlot, firstFigure} from '../src/campaign_plots.js';

const points = (series, y) => ({series, at: [0, 1], y, low: y.map((v) => v - 1), high: y.map((v) => v + 1), n: [2, 2]});
const data = {
  series: ['a', 'b', 'run'],
  names: ['distance_m', 'recovery.success'],
  axes: [
    {key: 'people.count', numeric: true, labels: ['0', '3'], x: [0, 3],
      figures: [[points(2, [5, 6])], [points(1, [1, 2])]]},
    {key: 'kind', numeric: false, labels: ['carry', 'push'], x: [0, 1],
      figures: [[points(2, [5, 6])], [points(0, [1, 2]), points(1, [2, 3])]]},
  ],
};

test('a localizer without the figure keeps its place and colour', () => {
  const {title, series, y} = curvesPlot(data, data.axes[0], 1);
  assert.equal(title, 'recovery.success over people.count');
  assert.deepEqual(series.map(({name, x}) => [name, x]), [['a', []], ['b', [0, 3]]]);
  assert.deepEqual(y, {range: [0, 1]});
});

test('a figure of the run is one series, whose intervals are within the axis', () => {
  const {series, y} = curvesPlot(data, data.axes[0], 0);
  assert.deepEqual(series.map(({name}) => name), ['run']);
  assert.ok(y.least > 7);
});

test('values that are no numbers are dots with names, beside each other', () => {
  const {x, series} = curvesPlot(data, data.axes[1], 1);
  assert.deepEqual(x.names, ['carry', 'push']);
  assert.deepEqual(x.range, [-0.5, 1.5]);
  assert.deepEqual(series.map(({style}) => style), ['points', 'points']);
  assert.ok(series[0].x[0] < 0 && series[1].x[0] > 0);
});

test('the share of recovered kidnaps comes first', () => {
  assert.equal(firstFigure(data.names), 1);
  assert.equal(firstFigure(['cpu']), 0);
});
