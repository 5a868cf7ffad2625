// How a page describes its plots. Behind each empty element of class "plots" stands a script of JSON, written by
// tools/report/html/plot_data.hpp:
//   {x: numbers that series share, plots: [{title, unit, x: axis, y: axis, series, limit, marks, nothing}]}
//   axis: {label, range: [low, high], log: [low, high], least, names}; range is fixed, log narrows to the data, an
//   axis without either goes from 0 to the largest value, or to `least` (y), or is as wide as the data (x); names: of
//   the places 0, 1, 2 of an x axis without numbers
//   series: [{name, x, y, style, low, high}]; x: its own; low, high: an interval at each point
//   style: none (a line), band (a line in the area of its intervals), dots (many), points (few, large), marked (a line
//     with dots), steps, reference (dotted, in no localizer's colour; first)
//   limit: a dotted line across; marks: dashed lines down; nothing: what is written where no series has points

/** A plot's description with what it leaves out; `shared`: the x of its group. */
export function complete(plot, shared) {
  return {x: {label: 'time [s]'}, y: {}, ...plot, shared};
}

/** True if no series but references has points. */
export function isEmpty({series}) {
  return series.every(({y, style}) => style === 'reference' || y.length === 0);
}
