// The layer of the map that shows where a localizer was wrong; a scene is that of layers.js.
import {errorPieces} from './error_scale.js';
import {pieces} from './poses.js';
import {toScreen} from './view.js';

/** The true path in the colours of a localizer's position error. */
export function drawErrors(context, {recording, view, colors, onLevel, errors, errorOf}) {
  if (errorOf < 0 || !errors) return;
  const scans = [];
  const parts = pieces(recording.truth, 0, recording.scans - 1, onLevel, null, scans);
  context.save();
  context.lineJoin = context.lineCap = 'round';
  context.lineWidth = 4;
  for (const {step, points} of errorPieces(parts, scans.map((part) => part.map((i) => errors[errorOf].position[i])))) {
    context.strokeStyle = step < 0 ? colors.soft : colors.errors[step];
    context.beginPath();
    for (let i = 0; i < points.length; i += 2) context.lineTo(...toScreen(view, points[i], points[i + 1]));
    context.stroke();
  }
  context.restore();
}
