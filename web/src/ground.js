// The map itself and the scale bar; a scene is that of layers.js.
import {barLength, toScreen} from './view.js';

export function drawMap(context, {map, view, colors, mapCanvas}) {
  context.fillStyle = colors.unknown;
  context.fillRect(0, 0, view.width, view.height);
  if (!mapCanvas) return;
  const {origin: [x, y, yaw], resolution_m: cell, height} = map;
  const [px, py] = toScreen(view, x, y);
  context.save();
  context.translate(px, py);
  context.rotate(-yaw);
  context.scale(view.scale * cell, view.scale * cell);
  context.imageSmoothingEnabled = view.scale * cell < 1.5;
  context.drawImage(mapCanvas, 0, -height);
  context.restore();
}

export function drawScaleBar(context, {view, colors}) {
  const length = barLength(view);
  const px = length * view.scale;
  const [x, y] = [14, view.height - 16];
  context.globalAlpha = 0.8;
  context.fillStyle = colors.card;
  context.fillRect(x - 6, y - 22, px + 12, 28);
  context.globalAlpha = 1;
  context.strokeStyle = colors.ink;
  context.fillStyle = colors.ink;
  context.lineWidth = 2;
  context.beginPath();
  context.moveTo(x, y - 5);
  context.lineTo(x, y);
  context.lineTo(x + px, y);
  context.lineTo(x + px, y - 5);
  context.stroke();
  context.font = '12px system-ui, sans-serif';
  context.textAlign = 'center';
  context.fillText(`${length} m`, x + px / 2, y - 7);
  context.textAlign = 'start';
}
