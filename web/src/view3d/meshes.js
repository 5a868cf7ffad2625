// Meshes and matrices as plain numbers; tools/build/scene/page_scene.hpp writes the meshes.
import {fromBase64} from '../bytes.js';

/** Numbers of a type in base64 text; the bytes are little-endian, as in all browsers. */
function numbersOf(Type, text) {
  const bytes = fromBase64(text);
  return new Type(bytes.buffer, 0, bytes.length / Type.BYTES_PER_ELEMENT);
}

/** A mesh of the page's JSON; null where there is none. */
export function unpackMesh(json) {
  if (!json) return null;
  return {
    positions: numbersOf(Float32Array, json.positions),
    normals: numbersOf(Int8Array, json.normals),
    colors: numbersOf(Uint8Array, json.colors),
    indices: numbersOf(Uint32Array, json.indices),
  };
}

/** T_map_base, column by column, of {x, y, yaw}; `lift`: [height, roll, pitch] of base. [m], [rad] */
export function poseMatrix({x, y, yaw}, lift = [0, 0, 0]) {
  const [height, roll, pitch] = lift;
  const [cy, sy, cp, sp] = [Math.cos(yaw), Math.sin(yaw), Math.cos(pitch), Math.sin(pitch)];
  const [cr, sr] = [Math.cos(roll), Math.sin(roll)];
  return [
    cy * cp, sy * cp, -sp, 0,
    cy * sp * sr - sy * cr, sy * sp * sr + cy * cr, cp * sr, 0,
    cy * sp * cr + sy * sr, sy * sp * cr - cy * sr, cp * cr, 0,
    x, y, height, 1];
}

/** The same for a thing on the floor at height z, larger by `scale` about its middle. */
export function floorMatrix({x, y, yaw}, z, scale = 1) {
  const [c, s] = [scale * Math.cos(yaw), scale * Math.sin(yaw)];
  return [c, s, 0, 0, -s, c, 0, 0, 0, 0, scale, 0, x, y, z, 1];
}

/** The flat outline of `corners` corners (0: a circle) between two radii, in the plane z = 0: [positions, indices]. */
export function ringMesh(corners, inner, outer, turn = 0) {
  const count = corners || 40;
  const positions = [];
  const indices = [];
  for (let i = 0; i < count; ++i) {
    const angle = turn + (2 * Math.PI * i) / count;
    for (const radius of [inner, outer]) positions.push(radius * Math.cos(angle), radius * Math.sin(angle), 0);
    const [a, b] = [2 * i, 2 * ((i + 1) % count)];
    indices.push(a, a + 1, b + 1, a, b + 1, b);
  }
  return [positions, indices];
}

/** A flat band of `width` along each line [x, y, x, y...] at height z, above `heights` [[z...]...]: [positions, indices]. */
export function ribbonMesh(lines, width, z, heights = []) {
  const positions = [];
  const indices = [];
  lines.forEach((line, index) => {
    const count = line.length / 2;
    if (count < 2) return;
    const first = positions.length / 3;
    for (let i = 0; i < count; ++i) {
      const [from, to] = [2 * Math.max(0, i - 1), 2 * Math.min(count - 1, i + 1)];
      const [dx, dy] = [line[to] - line[from], line[to + 1] - line[from + 1]];
      const half = width / 2 / (Math.hypot(dx, dy) || 1);
      const up = z + (heights[index]?.[i] ?? 0);
      positions.push(line[2 * i] - dy * half, line[2 * i + 1] + dx * half, up,
        line[2 * i] + dy * half, line[2 * i + 1] - dx * half, up);
      if (i === 0) continue;
      const at = first + 2 * i;
      indices.push(at - 2, at - 1, at + 1, at - 2, at + 1, at);
    }
  });
  return [positions, indices];
}

/** Points of an arc from one place [x, y] or [x, y, z] on the floor to another: [x, y, z...]. */
export function arcPoints(from, to, count = 40) {
  const [low, high] = [from[2] ?? 0, to[2] ?? 0];
  const height = 0.35 * Math.hypot(to[0] - from[0], to[1] - from[1]) + 0.4;
  const points = [];
  for (let i = 0; i <= count; ++i) {
    const t = i / count;
    points.push(from[0] + t * (to[0] - from[0]), from[1] + t * (to[1] - from[1]), low + t * (high - low) + 0.1 + 4 * height * t * (1 - t));
  }
  return points;
}
