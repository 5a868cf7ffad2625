// How a page describes its plots. Behind each empty element of class "plots" stands a script of JSON, written by
// tools/pages/html/plot_data.hpp:
//   {x: numbers that series share, plots: [{title, unit, x: axis, y: axis, series, limit, marks, nothing, localizers}]}
//   axis: {label, range: [low, high], log: [low, high], least, names}; range is fixed, log narrows to the data, an
//   axis without either goes from 0 to the largest value, or to `least` (y), or is as wide as the data (x); names: of
//   the places 0, 1, 2 of an x axis without numbers
//   series: [{name, x, y, style, low, high, weight, color, dash}]; x: its own; low, high: an interval at each point;
//     color: index into the palette, else its place among them; dash: of one that shares its color
//   localizers: true where each series is a localizer and has its name: the colours follow from the names
//   style: none (a line), band (a line in the area of its intervals), dots (many), points (few, large), marked (a line
//     with dots), sized (dots as large as their weight on a thin line), steps, reference (dotted, in no localizer's colour; first)
//   limit: a dotted line across; marks: dashed lines down; nothing: what is written where no series has points

import {stylesOf} from './palette.js';

/** A plot's description with what it leaves out; `shared`: the x of its group. */
export function complete(plot, shared) {
  return {x: {label: 'time [s]'}, y: {}, ...plot, shared};
}

/** True if no series but references has points. */
export function isEmpty({series}) {
  return series.every(({y, style}) => style === 'reference' || y.length === 0);
}

/**
 * Index into the palette of each series of a plot: its `color`, or that of the localizer with its name, or its place among
 * them; -1 of references.
 */
export function seriesStyles({series, localizers}) {
  const own = series.filter(({style, color}) => style !== 'reference' && color === undefined);
  const styles = localizers ? stylesOf(own.map(({name}) => name)) : own.map((_, i) => i);
  return series.map((one) => (one.style === 'reference' ? -1 : one.color ?? styles[own.indexOf(one)]));
}

/** Three digits of small numbers, two decimals of large ones, none of whole ones. */
export function valueText(value) {
  if (value === null || value === undefined) return '\u2013';
  if (Number.isInteger(value)) return String(value);
  return Math.abs(value) < 1 ? value.toPrecision(3) : value.toFixed(2);
}
