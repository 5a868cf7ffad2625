// A plot by uPlot, from its description; see plot_spec.js for its parts.
import uPlot from 'uplot';
import {element} from './dom.js';
import {kDashes, pick} from './palette.js';
import {seriesStyles, valueText} from './plot_spec.js';
import {align, clip, logRange, powersOfTen, rangeFromZero, tickTexts} from './plot_columns.js';
import {drawBand, drawIntervals, drawLimit, drawSized} from './plot_marks.js';

const kFont = '12px system-ui, sans-serif';
const kLegendLines = ['solid', 'dashed', 'dotted', 'double', 'dashed', 'dotted'];
const kLogTicks = {
  splits: (_, __, low, high) => powersOfTen(low, high),
  filter: (_, ticks) => ticks,
  values: (_, ticks) => ticks.map(String),
};


function axisOf(axis, colors, size) {
  const line = {stroke: () => colors().line, width: 1};
  const label = axis.label ? {label: axis.label, labelSize: 16, labelFont: kFont} : {};
  return {stroke: () => colors().soft, font: kFont, grid: line, ticks: {...line, size: 4}, size, ...label,
    values: (_, ticks) => tickTexts(ticks), ...(axis.log ? kLogTicks : {}), ...(axis.names ? namesOf(axis.names) : {})};
}

/** Names at 0, 1, 2 instead of numbers. */
function namesOf(names) {
  return {splits: () => names.map((_, i) => i), values: (_, places) => places.map((i) => names[i] ?? '')};
}

/** The scale of an axis; `columns(plot)`: its data; `range`: of one that has no limits of its own. */
function scaleOf(axis, columns, range) {
  if (axis.log) return {time: false, distr: 3, range: (plot) => logRange(columns(plot), axis.log)};
  return {time: false, ...(axis.range ? {range: axis.range} : range)};
}

/** A series of a plot; `style`: as in plot_spec.js; `index`: into the palette. */
function seriesOf({name, style, dash}, index, colors) {
  const color = () => (index < 0 ? colors().soft : pick(colors().localizers, index));
  const line = {label: name, scale: 'y', width: 1.8, stroke: color, dash: pick(kDashes, Math.max(dash ?? index, 0)), spanGaps: false,
    points: {show: false}, value: (_, value) => valueText(value)};
  switch (style) {
    case 'dots':
      return {...line, paths: () => null,
        points: {show: true, size: 5, width: 0, space: 0, fill: () => `${color()}73`, stroke: color}};
    case 'points':
      return {...line, paths: () => null, points: {show: true, size: 9, width: 0, space: 0, fill: color, stroke: color}};
    case 'marked':
      return {...line, points: {show: true, size: 8, width: 1, space: 0, fill: color, stroke: color}};
    case 'sized':
      return {...line, width: 1};
    case 'steps':
      return {...line, paths: uPlot.paths.stepped({align: 1}), fill: () => `${color()}26`};
    case 'reference':
      return {...line, width: 1, dash: [2, 3], stroke: () => colors().soft};
    default:
      return line;
  }
}

/** Swatches of the legend in the page's colours, also after the theme has changed. */
function markersOf(spec, styles) {
  const dashOf = (i) => spec.series[i - 1].dash ?? styles[i - 1];
  return {width: 3, dash: (_, i) => (dashOf(i) < 0 ? 'dotted' : pick(kLegendLines, dashOf(i))),
    stroke: (_, i) => (styles[i - 1] < 0 ? 'var(--soft)' : `var(--c${styles[i - 1] % 6})`)};
}

/** Options of uPlot. */
function optionsOf(spec, size, colors, more) {
  const styles = seriesStyles(spec);
  return {
    ...size,
    scales: {
      x: scaleOf(spec.x, ({data}) => [data[0]], {}),
      y: scaleOf(spec.y, ({data}) => data.slice(1),
        {range: ({data}) => rangeFromZero(data.slice(1), spec.y.least ?? 0)}),
    },
    axes: [axisOf(spec.x, colors, 30), axisOf(spec.y, colors, spec.y.label ? 46 : 58)],
    series: [
      {label: spec.x.label, value: (_, value) => valueText(value)},
      ...spec.series.map((series, k) => seriesOf(series, styles[k], colors)),
    ],
    cursor: {drag: {x: true, y: false}, points: {size: 7}, ...more.cursor},
    legend: {markers: markersOf(spec, styles)},
    hooks: {draw: [(plot) => {
      spec.series.forEach((series, k) => {
        const color = styles[k] < 0 ? colors().soft : pick(colors().localizers, styles[k]);
        (series.style === 'band' ? drawBand : drawIntervals)(plot, series, color);
        if (series.style === 'sized') drawSized(plot, series, color);
      });
      if (spec.limit) drawLimit(plot, spec.limit, colors());
      more.draw?.(plot);
    }]},
  };
}

/** Adds a figure to `place`. Returns uPlot's object; `colors()`: the theme's; `more`: cursor, draw(plot). */
export function addPlot(place, spec, height, colors, more = {}) {
  const columns = align(spec.series, spec.shared);
  [spec.x, ...spec.series.map(() => spec.y)].forEach((axis, i) => {
    if (axis.log) columns[i] = clip(columns[i], axis.log);
  });
  const unit = spec.unit ? element('span', {class: 'unit'}, ` [${spec.unit}]`) : null;
  const figure = element('figure', {}, element('figcaption', {}, spec.title, unit));
  place.append(figure);
  const plot = new uPlot(optionsOf(spec, {width: widthIn(figure), height}, colors, more), columns, figure);
  const canvas = plot.ctx.canvas;
  canvas.setAttribute('role', 'img');
  canvas.setAttribute('aria-label', `${spec.title}: ${spec.series.map(({name}) => name).join(', ')}`);
  return plot;
}

/** Of a plot within the border of its figure. [px] */
export function widthIn(figure) {
  return Math.max(260, figure.clientWidth - 2);
}
