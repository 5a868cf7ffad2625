// Files that a page hands to its reader.
import {element} from './dom.js';

/** Saves bytes or text under a name. */
export function save(name, content, type) {
  const url = URL.createObjectURL(content instanceof Blob ? content : new Blob([content], {type}));
  element('a', {href: url, download: name}).click();
  setTimeout(() => URL.revokeObjectURL(url), 1000);
}

/** Saves canvases below each other, on `background`, as PNG. */
export function saveCanvases(name, canvases, background) {
  const sheet = document.createElement('canvas');
  sheet.width = Math.max(...canvases.map(({width}) => width));
  sheet.height = canvases.reduce((sum, {height}) => sum + height, 0);
  const context = sheet.getContext('2d');
  context.fillStyle = background;
  context.fillRect(0, 0, sheet.width, sheet.height);
  let top = 0;
  for (const canvas of canvases) {
    context.drawImage(canvas, 0, top);
    top += canvas.height;
  }
  sheet.toBlob((blob) => save(name, blob));
}
