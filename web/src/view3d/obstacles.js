// The map's obstacles, for a camera that must not stand in a wall.
import {Reader} from '../varint.js';

const kOccupied = 65;  // [%] As in map files.

/** Cells that are occupied, row 0 at the bottom. */
export function occupiedCells(bytes, {width, height}) {
  const cells = new Uint8Array(width * height);
  const reader = new Reader(bytes);
  for (let cell = 0; !reader.done;) {
    const value = reader.next() - 1;
    const count = reader.next();
    if (value >= kOccupied) cells.fill(1, cell, cell + count);
    cell += count;
  }
  return cells;
}

/** Distance from a point in map to the first obstacle in a direction [rad], at most `most`. [m] */
export function freeDistance(map, cells, {x, y}, direction, most) {
  const [x0, y0, yaw] = map.origin;
  const step = map.resolution_m;
  const [cos, sin] = [Math.cos(yaw), Math.sin(yaw)];
  for (let way = 0; way < most; way += step) {
    const [dx, dy] = [x + way * Math.cos(direction) - x0, y + way * Math.sin(direction) - y0];
    const column = Math.floor((cos * dx + sin * dy) / step);
    const row = Math.floor((cos * dy - sin * dx) / step);
    if (column < 0 || row < 0 || column >= map.width || row >= map.height) continue;
    if (cells[row * map.width + column]) return way;
  }
  return most;
}
