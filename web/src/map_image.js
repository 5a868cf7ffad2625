// The map as a picture of one pixel a cell.
import {rgb} from './palette.js';
import {Reader} from './varint.js';

/** RGBA of the cells, row 0 at the top. */
export function mapPixels(bytes, map, colors) {
  const pixels = new Uint8ClampedArray(4 * map.width * map.height);
  const [free, wall, unknown] = [colors.free, colors.wall, colors.unknown].map(rgb);
  const reader = new Reader(bytes);
  for (let cell = 0; !reader.done;) {
    const value = reader.next() - 1;
    const share = value / 100;
    const color = value < 0 ? unknown : free.map((c, i) => c + (wall[i] - c) * share);
    for (let left = reader.next(); left > 0; --left, ++cell) {
      const row = map.height - 1 - Math.floor(cell / map.width);
      const at = 4 * (row * map.width + (cell % map.width));
      pixels[at] = color[0];
      pixels[at + 1] = color[1];
      pixels[at + 2] = color[2];
      pixels[at + 3] = 255;
    }
  }
  return pixels;
}

/** A canvas with a map whose cells are in this section; nothing where it has none. */
export function mapCanvas(recording, colors, map = recording.header.map, section = 'map') {
  if (!map.width || !map.height) return null;
  const canvas = document.createElement('canvas');
  canvas.width = map.width;
  canvas.height = map.height;
  const pixels = mapPixels(recording.sections.get(section), map, colors);
  canvas.getContext('2d').putImageData(new ImageData(pixels, map.width, map.height), 0, 0);
  return canvas;
}
