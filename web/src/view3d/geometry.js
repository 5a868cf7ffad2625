// Meshes as three.js wants them.
import {BufferAttribute, BufferGeometry, DoubleSide, ShaderMaterial} from 'three';

/** Geometry of an unpacked mesh (meshes.js). */
export function geometryOf({positions, normals, colors, indices}) {
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(positions, 3));
  geometry.setAttribute('normal', new BufferAttribute(normals, 3, true));
  geometry.setAttribute('color', new BufferAttribute(colors, 3, true));
  geometry.setIndex(new BufferAttribute(indices, 1));
  return geometry;
}

/** A flat rectangle facing up over [x, y, x, y]. `color`: in [0, 1]. */
export function floorGeometry([left, bottom, right, upper], color) {
  const geometry = geometryOf({
    positions: new Float32Array([left, bottom, 0, right, bottom, 0, right, upper, 0, left, upper, 0]),
    normals: new Int8Array([0, 0, 127, 0, 0, 127, 0, 0, 127, 0, 0, 127]),
    colors: new Uint8Array([0, 1, 2, 3].flatMap(() => color.map((value) => Math.round(255 * value)))),
    indices: new Uint32Array([0, 1, 2, 0, 2, 3]),
  });
  geometry.setAttribute('uv', new BufferAttribute(new Float32Array([0, 0, 1, 0, 1, 1, 0, 1]), 2));
  return geometry;
}

/** Geometry of flat meshes [positions, indices, own: 1 or 0] for the shader of signs. */
export function signGeometry(parts) {
  const positions = [];
  const colors = [];
  const indices = [];
  for (const [corners, triangles, own] of parts) {
    const first = positions.length / 3;
    positions.push(...corners);
    for (let i = 0; i < corners.length / 3; ++i) colors.push(own, own, own);
    indices.push(...triangles.map((index) => first + index));
  }
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(new Float32Array(positions), 3));
  geometry.setAttribute('color', new BufferAttribute(new Float32Array(colors), 3));
  geometry.setIndex(indices);
  return geometry;
}

/** A material of own shaders; `uniforms`: values by name, of which `shared` ones are one object for all materials. */
export function material(vertexShader, fragmentShader, {uniforms = {}, shared = {}, ...more} = {}) {
  const own = Object.fromEntries(Object.entries(uniforms).map(([name, value]) => [name, {value}]));
  return new ShaderMaterial({vertexShader, fragmentShader, uniforms: {...shared, ...own}, side: DoubleSide, vertexColors: true,
    ...more});
}

/** Material of what lies flat on the floor, shown through it and through walls. */
export function signMaterial(vertexShader, fragmentShader, options = {}) {
  return material(vertexShader, fragmentShader, {transparent: true, depthWrite: false, ...options});
}
