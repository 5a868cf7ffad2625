// Plots as vector graphics: what uPlot has drawn on its canvases, to be saved.
import {kDashes, pick} from './palette.js';

const kFont = 'font-family="system-ui, sans-serif" font-size="12"';
const kHead = 24;  // [px] Height of a plot's title.
const kFoot = 20;  // [px] Height of the legend below all plots.

function escape(words) {
  return String(words).replace(/[&<>"]/g, (c) => `&#${c.charCodeAt(0)};`);
}

function text(x, y, words, color, anchor = 'start') {
  return `<text x="${x.toFixed(1)}" y="${y.toFixed(1)}" text-anchor="${anchor}" fill="${color}" ${kFont}>${escape(words)}</text>`;
}

function line([x1, y1, x2, y2], color, dash = '') {
  const [a, b, c, d] = [x1, y1, x2, y2].map((value) => value.toFixed(1));
  return `<path d="M${a} ${b}L${c} ${d}" stroke="${color}" fill="none"${dash && ` stroke-dasharray="${dash}"`}/>`;
}

/** Points of a series as a path, with a new start behind each gap. `place(x, y)`: in pixels. */
export function pathData(xs, ys, place) {
  let data = '';
  let joined = false;
  xs.forEach((x, i) => {
    if (ys[i] === undefined) return;
    if (ys[i] !== null) {
      const [px, py] = place(x, ys[i]);
      data += `${joined ? 'L' : 'M'}${px.toFixed(1)} ${py.toFixed(1)}`;
    }
    joined = ys[i] !== null;
  });
  return data;
}

/** A plot of {plot: uPlot's object, title, unit, styles: of its series, marks: [{time, color}], limit} at the height `top`. */
function plotPart({plot, title, unit, styles, marks = [], limit}, top, colors) {
  const ratio = devicePixelRatio;
  const [left, high, width, height] = [plot.bbox.left, plot.bbox.top, plot.bbox.width, plot.bbox.height].map((px) => px / ratio);
  const x = (value) => left + plot.valToPos(value, 'x');
  const y = (value) => top + high + plot.valToPos(value, 'y');
  const low = top + high + height;
  const id = `clip${Math.round(top)}`;
  const parts = [text(left, top + 14, unit ? `${title} [${unit}]` : title, colors.ink),
    `<clipPath id="${id}"><rect x="${left}" y="${top + high}" width="${width}" height="${height}"/></clipPath>`];
  const [across, upright] = plot.axes;
  across._splits.forEach((value, i) => parts.push(line([x(value), top + high, x(value), low], colors.line),
    text(x(value), low + 16, across._values[i], colors.soft, 'middle')));
  upright._splits.forEach((value, i) => parts.push(line([left, y(value), left + width, y(value)], colors.line),
    text(left - 6, y(value) + 4, upright._values[i], colors.soft, 'end')));
  if (limit) parts.push(line([left, y(limit), left + width, y(limit)], colors.soft, '2 3'));
  parts.push(`<g clip-path="url(#${id})">`);
  for (const {time, color} of marks) parts.push(line([x(time), top + high, x(time), low], colors[color], '5 4'));
  plot.data.slice(1).forEach((values, k) => {
    const data = pathData(plot.data[0], values, (px, py) => [x(px), y(py)]);
    const color = pick(colors.localizers, styles[k]);
    parts.push(`<path d="${data}" fill="none" stroke="${color}" stroke-width="1.6" stroke-dasharray="${pick(kDashes, styles[k]).join(' ')}"/>`);
  });
  parts.push('</g>', text(left + width, low + 34, across.label ?? '', colors.soft, 'end'));
  return parts.join('\n');
}

/** Plots of one set of series below each other as one SVG; `names`: of the series. */
export function plotsSvg(plots, names, colors) {
  const heights = plots.map(({plot}) => kHead + plot.height);
  const width = Math.max(...plots.map(({plot}) => plot.width));
  const height = heights.reduce((sum, one) => sum + one, kFoot);
  let top = 0;
  const parts = plots.map((plot, i) => {
    const part = plotPart(plot, top, colors);
    top += heights[i];
    return part;
  });
  const legend = names.map((name, k) => {
    const left = 60 + (k * (width - 80)) / names.length;
    const style = plots[0].styles[k];
    return `<path d="M${left.toFixed(1)} ${height - 10}h26" stroke="${pick(colors.localizers, style)}" stroke-width="2" `
      + `stroke-dasharray="${pick(kDashes, style).join(' ')}"/>${text(left + 32, height - 6, name, colors.ink)}`;
  });
  return `<svg xmlns="http://www.w3.org/2000/svg" width="${width}" height="${height}" viewBox="0 0 ${width} ${height}">\n`
    + `<rect width="100%" height="100%" fill="${colors.page}"/>\n${[...parts, ...legend].join('\n')}\n</svg>\n`;
}
