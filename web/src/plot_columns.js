// Numbers of a plot as uPlot takes them.

/**
 * One x column that ascends and one column of values for each series. A series has its own `x`, or that of all,
 * `shared`. Where a series has no point at an x that others have, its value is undefined: not a gap (null).
 */
export function align(series, shared) {
  if (series.every(({x}) => x === undefined)) return [shared, ...series.map(({y}) => y)];
  const points = series.flatMap(({x = shared, y}, k) => x.map((value, i) => ({x: value, y: y[i], k})));
  points.sort((a, b) => a.x - b.x);  // Stable: points of one x stay in their order.
  const columns = Array.from({length: series.length + 1}, () => []);
  for (const {x, y, k} of points) {
    const last = columns[0].length - 1;
    const joins = columns[0][last] === x && columns[k + 1][last] === undefined;
    if (!joins) columns.forEach((column, i) => column.push(i === 0 ? x : undefined));
    columns[k + 1][joins ? last : last + 1] = y;
  }
  return columns;
}

/** From 0 to a bit above the largest value, or to `least` if that is more. */
export function rangeFromZero(columns, least) {
  const most = columns.reduce((all, values) => values.reduce((a, v) => Math.max(a, v ?? 0), all), 0);
  return [0, Math.max(least, 1.05 * most) || 1];
}

/** Values within an axis: a logarithmic one takes no zero. */
export function clip(values, [low, high]) {
  return values.map((v) => (v === null || v === undefined ? v : Math.min(high, Math.max(low, v))));
}

/** The powers of ten, within the axis, that all values and 0.1 to 1 lie between. */
export function logRange(columns, [low, high]) {
  let least = Infinity;
  let most = low;
  for (const values of columns) {
    for (const value of values) {
      if (value === null || value === undefined) continue;
      least = Math.min(least, value);
      most = Math.max(most, value);
    }
  }
  const floor = 10 ** Math.floor(Math.log10(Math.max(low, Math.min(least, 1))));
  return [Math.min(floor, 0.1), Math.min(high, Math.max(1, 10 ** Math.ceil(Math.log10(most))))];
}

/** Ticks of equal distance as texts, with as many decimals as their distance asks for. */
export function tickTexts(ticks) {
  const step = ticks.length > 1 ? Math.abs(ticks[1] - ticks[0]) : Math.abs(ticks[0] ?? 1) || 1;
  const told = (decimals) => Math.abs(step * 10 ** decimals - Math.round(step * 10 ** decimals)) < 1e-6;
  let decimals = Math.max(0, Math.ceil(-Math.log10(step) - 1e-9));
  while (decimals < 12 && !told(decimals)) ++decimals;
  return ticks.map((tick) => (tick === null ? '' : tick.toFixed(Math.min(decimals, 20))));
}

/** Powers of ten from `low` to `high`. */
export function powersOfTen(low, high) {
  const ticks = [];
  for (let power = Math.ceil(Math.log10(low) - 1e-6); 10 ** power <= high * 1.000001; ++power) {
    ticks.push(Number(`1e${power}`));
  }
  return ticks;
}
