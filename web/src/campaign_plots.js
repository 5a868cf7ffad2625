// Descriptions of the plots of a campaign's page, as plot_spec.js has them, from the data that
// tools/pages/campaign/figures/key_figures.cpp writes:
//   {series: labels, styles: into the palette, names: figures, units: of them, axes: [{key, unit, numeric, labels, x, figures}]}
//   figures: for each name [{series, at: places, y, low, high, n}]

const kShare = 'recovery.success';  // Of the recovered kidnaps.
const kApart = 0.06;  // Between the dots of two series at one value that is no number.

/** The series of a localizer, or without points if it has none: colours follow from the order. */
function seriesOf(axis, label, color, k, count, points) {
  const shift = axis.numeric ? 0 : kApart * (k - (count - 1) / 2);
  const style = axis.numeric ? 'marked' : 'points';
  if (!points) return {name: label, style, color, x: [], y: []};
  return {name: label, style, color, x: points.at.map((place) => axis.x[place] + shift), y: points.y, low: points.low,
    high: points.high};
}

/** "lidar.range_max [m]" */
function withUnit(name, unit) {
  return unit ? `${name} [${unit}]` : name;
}

/** Places with names instead of numbers. */
function axisOf(axis) {
  const label = withUnit(axis.key, axis.unit);
  if (axis.numeric) return {label};
  return {label, names: axis.labels, range: [-0.5, axis.labels.length - 0.5]};
}

/** One figure over one key, a series for each localizer; a figure of runs has a single series. */
export function curvesPlot(data, axis, figure) {
  const drawn = axis.figures[figure];
  const last = data.series.length - 1;  // The run.
  const ofRun = data.series.length === 1 || drawn.some(({series}) => series === last);
  const labels = ofRun ? [[data.series[last], last]] : data.series.slice(0, last).map((label, k) => [label, k]);
  const most = Math.max(0, ...drawn.flatMap(({high}) => high));
  const y = {label: withUnit(data.names[figure], data.units[figure]),
    ...(data.names[figure] === kShare ? {range: [0, 1]} : {least: 1.02 * most})};
  return {title: `${data.names[figure]} over ${axis.key}`, x: axisOf(axis), y,
    nothing: 'No figures.',
    series: labels.map(([label, k], i) =>
      seriesOf(axis, label, data.styles[k], i, labels.length, drawn.find(({series}) => series === k)))};
}

const kMain = [kShare, 'recovery.time_s.median', 'tracking_error_m.mean', 'wrong_lock_share', 'availability'];

/** Groups of the figures' names, [[title, names]...]: what is asked for most, and all of them in order. */
export function figureGroups(names) {
  const main = kMain.filter((name) => names.includes(name));
  return [['most asked for', main], ['all', [...names].sort()]].filter(([, members]) => members.length > 0);
}

/** The figure that a page shows first: the share of recovered kidnaps, if it has that. */
export function firstFigure(names) {
  return Math.max(0, names.indexOf(kShare));
}
