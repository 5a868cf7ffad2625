// Points and bands of the 3-D view: scans, particles, populations, trails, kidnaps, and soft shadows.
import {BufferAttribute, BufferGeometry, Color, InstancedMesh, Matrix4, Mesh, Points} from 'three';
import {geometryOf, material, signGeometry, signMaterial} from './geometry.js';
import {arcPoints, floorMatrix, ribbonMesh, ringMesh} from './meshes.js';
import {
  kBlobFragment, kLitVertex, kPointFragment, kPointVertex, kSignFragment, kSignVertex,
} from './shaders.js';

/** Points of changing number. */
export class Dots {
  constructor(most, size, {opacity = 1, order = 0, depthTest = true} = {}) {
    this.most = most;
    this.positions = new Float32Array(3 * most);
    this.colors = new Float32Array(3 * most);
    this.geometry = new BufferGeometry();
    this.geometry.setAttribute('position', new BufferAttribute(this.positions, 3));
    this.geometry.setAttribute('color', new BufferAttribute(this.colors, 3));
    this.object = new Points(this.geometry,
      material(kPointVertex, kPointFragment, {uniforms: {size, opacity}, transparent: true, depthWrite: false, depthTest}));
    this.object.frustumCulled = false;
    this.object.renderOrder = order;
    this.clear();
  }

  clear() {
    this.count = 0;
  }

  add(x, y, z, color) {
    if (this.count >= this.most) return;
    this.positions.set([x, y, z], 3 * this.count);
    this.colors.set(color, 3 * this.count);
    ++this.count;
  }

  /** To be called after the last of them. `size` [px] */
  done(size) {
    this.object.material.uniforms.size.value = size;
    this.object.visible = this.count > 0;
    this.geometry.setDrawRange(0, this.count);
    for (const name of ['position', 'color']) this.geometry.getAttribute(name).needsUpdate = true;
  }
}

/** A band along a way on the floor. */
export class Trail {
  constructor(opacity, order) {
    this.object = new Mesh(new BufferGeometry(),
      signMaterial(kSignVertex, kSignFragment, {vertexColors: false, uniforms: {tint: new Color(), rim: new Color(), opacity}}));
    this.object.frustumCulled = false;
    this.object.renderOrder = order;
  }

  show(lines, width, z, color, heights) {
    const [positions, indices] = ribbonMesh(lines, width, z, heights);
    this.object.visible = indices.length > 0;
    this.object.geometry.dispose();
    const geometry = new BufferGeometry();
    geometry.setAttribute('position', new BufferAttribute(new Float32Array(positions), 3));
    geometry.setIndex(indices);
    this.object.geometry = geometry;
    this.object.material.uniforms.tint.value.setRGB(...color);
  }
}

/** Copies of a flat sign of one colour each. */
class Copies {
  constructor(geometry, ownMaterial, most, order) {
    this.object = new InstancedMesh(geometry, ownMaterial, most);
    this.object.frustumCulled = false;
    this.object.renderOrder = order;
    this.most = most;
    this.matrix = new Matrix4();
    this.color = new Color();
    this.clear();
  }

  clear() {
    this.object.count = 0;
  }

  add(pose, z, size, color) {
    if (this.object.count >= this.most) return;
    this.object.setMatrixAt(this.object.count, this.matrix.fromArray(floorMatrix(pose, z, size)));
    if (color) this.object.setColorAt(this.object.count, this.color.setRGB(...color));
    ++this.object.count;
  }

  done() {
    this.object.visible = this.object.count > 0;
    this.object.instanceMatrix.needsUpdate = true;
    if (this.object.instanceColor) this.object.instanceColor.needsUpdate = true;
  }
}

/** Soft shadows under what moves. */
export function softShadows(most) {
  return new Copies(signGeometry([[...ringMesh(0, 0, 1), 1]]), signMaterial(kSignVertex, kBlobFragment), most, 1);
}

const kPlainFragment = `
varying vec3 ownColor;
void main() { gl_FragColor = vec4(ownColor, 0.85); }`;

/** Arrows of populations. */
export function arrows(most) {
  const corners = [0, -0.09, 0, 0.6, -0.09, 0, 0.6, 0.09, 0, 0, 0.09, 0, 0.6, -0.28, 0, 1, 0, 0, 0.6, 0.28, 0];
  const count = corners.length / 3;
  const geometry = geometryOf({
    positions: new Float32Array(corners), normals: new Int8Array(3 * count).fill(127),
    colors: new Uint8Array(3 * count).fill(255), indices: new Uint32Array([0, 1, 2, 0, 2, 3, 4, 5, 6]),
  });
  const copies = new Copies(geometry, signMaterial(kLitVertex, kPlainFragment), most, 3);
  copies.object.setColorAt(0, new Color(1, 1, 1));
  return copies;
}

/** Adds the arc of a kidnap. */
export function addArc(dots, from, to, color) {
  const points = arcPoints(from, to, Math.min(120, Math.max(12, Math.round(8 * Math.hypot(to[0] - from[0], to[1] - from[1])))));
  for (let i = 0; i < points.length; i += 3) dots.add(points[i], points[i + 1], points[i + 2], color);
}
