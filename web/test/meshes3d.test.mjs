import assert from 'node:assert/strict';
import {test} from 'node:test';
import * as m from '../src/view3d/meshes.js';
import {near} from './fixture.mjs';

const base64 = (values) => Buffer.from(values.buffer).toString('base64');

/** A column-major matrix times a point. */
const times = (T, [x, y, z]) => [0, 1, 2].map((row) => T[row] * x + T[row + 4] * y + T[row + 8] * z + T[row + 12]);

test('a mesh is unpacked', () => {
  const mesh = m.unpackMesh({
    positions: base64(new Float32Array([1.5, -2, 3])), normals: base64(new Int8Array([0, -127, 0])),
    colors: base64(new Uint8Array([255, 128, 0])), indices: base64(new Uint32Array([0, 70000, 2])),
  });
  assert.deepEqual([...mesh.positions], [1.5, -2, 3]);
  assert.deepEqual([...mesh.normals], [0, -127, 0]);
  assert.deepEqual([...mesh.colors], [255, 128, 0]);
  assert.deepEqual([...mesh.indices], [0, 70000, 2]);
  assert.equal(m.unpackMesh(null), null);
});

test('a ghost stands at its pose, and faces along it', () => {
  const T = m.poseMatrix({x: 1, y: 2, yaw: Math.PI / 2});
  assert.ok(near(times(T, [0, 0, 0]), [1, 2, 0]));
  assert.ok(near(times(T, [1, 0, 0.5]), [1, 3, 0.5]));
  assert.ok(near(times(T, [0, 1, 0]), [0, 2, 0]));
});

test('base is lifted, rolled and pitched before it is turned', () => {
  const pose = {x: 0, y: 0, yaw: Math.PI / 2};
  assert.ok(near(times(m.poseMatrix(pose, [0.3, 0, 0]), [1, 0, 0]), [0, 1, 0.3]));
  const nose = times(m.poseMatrix(pose, [0, 0, 0.1]), [1, 0, 0]);
  assert.ok(near(nose, [0, Math.cos(0.1), -Math.sin(0.1)]), 'a positive pitch puts the nose down');
  const left = times(m.poseMatrix(pose, [0, 0.1, 0]), [0, 1, 0]);
  assert.ok(near(left, [-Math.cos(0.1), 0, Math.sin(0.1)]), 'a positive roll lifts the left side');
  const T = m.poseMatrix({x: 0, y: 0, yaw: 0.7}, [0, 0.2, 0.3]);
  const dot = (a, b) => T[4 * a] * T[4 * b] + T[4 * a + 1] * T[4 * b + 1] + T[4 * a + 2] * T[4 * b + 2];
  assert.ok(near([dot(0, 0), dot(1, 1), dot(2, 2), dot(0, 1), dot(1, 2)], [1, 1, 1, 0, 0]));
});

test('a sign on the floor is scaled about its middle', () => {
  assert.ok(near(times(m.floorMatrix({x: 1, y: 2, yaw: Math.PI / 2}, 0.01, 3), [1, 0, 0]), [1, 5, 0.01]));
});

test('a ring has two corners an edge, and triangles that face up', () => {
  const [positions, indices] = m.ringMesh(4, 1, 2);
  assert.equal(positions.length, 3 * 8);
  assert.equal(indices.length, 3 * 8);
  for (let i = 0; i < indices.length; i += 3) {
    const [a, b, c] = [0, 1, 2].map((k) => positions.slice(3 * indices[i + k], 3 * indices[i + k] + 2));
    assert.ok((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]) > 0);
  }
  assert.equal(m.ringMesh(0, 1, 2)[0].length, 3 * 80);
});

test('a band is as wide as asked for; a point has none', () => {
  const [positions, indices] = m.ribbonMesh([[0, 0, 1, 0, 2, 0], [5, 5]], 0.2, 0.01);
  assert.ok(near(positions.slice(0, 6), [0, 0.1, 0.01, 0, -0.1, 0.01]));
  assert.equal(positions.length, 18);
  assert.equal(indices.length, 12);
});

test('an arc begins and ends near the floor, and is highest in the middle', () => {
  const points = m.arcPoints([0, 0], [4, 0], 10);
  assert.ok(near([...points.slice(0, 3), ...points.slice(-3)], [0, 0, 0.1, 4, 0, 0.1]));
  assert.ok(points[17] > 1.5 && near([points[15]], [2]));
});

test('bands and arcs follow heights', () => {
  const [positions] = m.ribbonMesh([[0, 0, 1, 0]], 0.2, 0.01, [[3, 4]]);
  assert.ok(near(positions.filter((_, i) => i % 3 === 2), [3.01, 3.01, 4.01, 4.01]));
  const points = m.arcPoints([0, 0, 6], [4, 0], 2);
  assert.ok(near([points[2], points[8]], [6.1, 0.1]));
});
