// Drawn over the curves, in canvas pixels: events, alarms, the limit between right and wrong, intervals.
import {pick} from './palette.js';

/** Vertical lines at events: recoveries dotted, all others dashed. */
export function drawMarks({ctx, bbox, valToPos}, marks, colors) {
  ctx.save();
  ctx.lineWidth = devicePixelRatio;
  for (const mark of marks) {
    const x = Math.round(valToPos(mark.time, 'x', true));
    if (x < bbox.left || x > bbox.left + bbox.width) continue;
    ctx.strokeStyle = colors[mark.color];
    ctx.setLineDash(mark.sort === 'recovery' ? [1, 4] : [5, 4]);
    ctx.beginPath();
    ctx.moveTo(x, bbox.top);
    ctx.lineTo(x, bbox.top + bbox.height);
    ctx.stroke();
  }
  ctx.restore();
}

/** A strip a localizer along the bottom while it says that it is lost; `styles`: into the palette. */
export function drawAlarms({ctx, bbox, valToPos}, alarms, colors, styles) {
  const high = 4 * devicePixelRatio;
  alarms.forEach((stretches, k) => {
    ctx.fillStyle = pick(colors.localizers, styles[k]);
    for (const {from, to} of stretches) {
      const left = Math.max(bbox.left, valToPos(from, 'x', true));
      const right = Math.min(bbox.left + bbox.width, valToPos(to, 'x', true));
      if (right < left) continue;
      const top = bbox.top + bbox.height - (k + 1) * (high + 1);
      ctx.fillRect(left, top, Math.max(2, right - left), high);
    }
  });
}

/** A dotted line across. */
export function drawLimit({ctx, bbox, valToPos}, limit, colors) {
  const y = Math.round(valToPos(limit, 'y', true));
  ctx.save();
  ctx.strokeStyle = colors.soft;
  ctx.lineWidth = devicePixelRatio;
  ctx.setLineDash([2, 3]);
  ctx.beginPath();
  ctx.moveTo(bbox.left, y);
  ctx.lineTo(bbox.left + bbox.width, y);
  ctx.stroke();
  ctx.restore();
}

/** The interval of a series with the style `band`, as an area behind its line. */
export function drawBand({ctx, valToPos}, {x, low, high}, color) {
  if (x.length === 0) return;
  ctx.save();
  ctx.fillStyle = `${color}26`;
  ctx.beginPath();
  x.forEach((value, i) => ctx.lineTo(valToPos(value, 'x', true), valToPos(high[i], 'y', true)));
  for (let i = x.length - 1; i >= 0; --i) ctx.lineTo(valToPos(x[i], 'x', true), valToPos(low[i], 'y', true));
  ctx.fill();
  ctx.restore();
}

const kLeastRadius = 4;  // [px]
const kMostRadius = 10;

/** Radii of dots whose areas grow with `weights`. [px] */
export function radiiOf(weights) {
  const most = Math.max(...weights, 1e-9);
  return weights.map((weight) => kLeastRadius + (kMostRadius - kLeastRadius) * Math.sqrt(Math.max(weight, 0) / most));
}

/** The dots of a series with the style `sized`, as large as their `weight`. */
export function drawSized({ctx, valToPos}, {x, y, weight}, color) {
  ctx.save();
  ctx.setLineDash([]);
  ctx.fillStyle = `${color}b3`;
  ctx.strokeStyle = color;
  ctx.lineWidth = 1.5 * devicePixelRatio;
  radiiOf(weight).forEach((radius, i) => {
    ctx.beginPath();
    ctx.arc(valToPos(x[i], 'x', true), valToPos(y[i], 'y', true), radius * devicePixelRatio, 0, 2 * Math.PI);
    ctx.fill();
    ctx.stroke();
  });
  ctx.restore();
}

/** The interval of each point of a series that has some, `low` to `high`, upright. */
export function drawIntervals({ctx, valToPos}, {x, low, high}, color) {
  if (!low) return;
  ctx.save();
  ctx.setLineDash([]);
  ctx.strokeStyle = color;
  ctx.lineWidth = 1.5 * devicePixelRatio;
  ctx.beginPath();
  x.forEach((value, i) => {
    const at = valToPos(value, 'x', true);
    ctx.moveTo(at, valToPos(low[i], 'y', true));
    ctx.lineTo(at, valToPos(high[i], 'y', true));
  });
  ctx.stroke();
  ctx.restore();
}
