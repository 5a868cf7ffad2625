// Descriptions of the plots of a campaign's page, as plot_spec.js has them, from the data that
// tools/campaign_page/key_figures.cpp writes:
//   {series: labels, names: figures, axes: [{key, numeric, labels, x, figures}]}
//   figures: for each name [{series, at: places, y, low, high, n}]

const kShare = 'recovery.success';  // Of the recovered kidnaps.
const kApart = 0.06;  // Between the dots of two series at one value that is no number.

/** The series of a localizer, or without points if it has none: colours follow from the order. */
function seriesOf(axis, label, k, count, points) {
  const shift = axis.numeric ? 0 : kApart * (k - (count - 1) / 2);
  const style = axis.numeric ? 'marked' : 'points';
  if (!points) return {name: label, style, x: [], y: []};
  return {name: label, style, x: points.at.map((place) => axis.x[place] + shift), y: points.y, low: points.low,
    high: points.high};
}

/** Places with names instead of numbers. */
function axisOf(axis) {
  if (axis.numeric) return {label: axis.key};
  return {label: axis.key, names: axis.labels, range: [-0.5, axis.labels.length - 0.5]};
}

/** One figure over one key, a series for each localizer; a figure of runs has a single series. */
export function curvesPlot(data, axis, figure) {
  const drawn = axis.figures[figure];
  const last = data.series.length - 1;  // The run.
  const ofRun = data.series.length === 1 || drawn.some(({series}) => series === last);
  const labels = ofRun ? [[data.series[last], last]] : data.series.slice(0, last).map((label, k) => [label, k]);
  const most = Math.max(0, ...drawn.flatMap(({high}) => high));
  const y = data.names[figure] === kShare ? {range: [0, 1]} : {least: 1.02 * most};
  return {title: `${data.names[figure]} over ${axis.key}`, x: axisOf(axis), y,
    nothing: 'No figures.',
    series: labels.map(([label, k], i) =>
      seriesOf(axis, label, i, labels.length, drawn.find(({series}) => series === k)))};
}

/** The figure that a page shows first: the share of recovered kidnaps, if it has that. */
export function firstFigure(names) {
  return Math.max(0, names.indexOf(kShare));
}
