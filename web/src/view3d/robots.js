// The robot of the 3-D view, and its ghosts: where the localizers believe that it is.
import {Color, Group, Mesh} from 'three';
import {geometryOf, material, signGeometry, signMaterial} from './geometry.js';
import {floorMatrix, poseMatrix, ringMesh, unpackMesh} from './meshes.js';
import {kGhostFragment, kLitVertex, kSignFragment, kSignVertex} from './shaders.js';

const kRing = 0.018;  // [m] Height of the rings above the floor.
const kLeastRing = 0.012;  // Of the distance from the eye.

/** A ring with an arrow: where a robot is and faces. `corners`: 0 for a circle. */
function ringGeometry(corners, turn) {
  const [inner, rim] = [0.88, 0.03];
  const arrow = (back, side, tip) => [[back, -side, 0, tip, 0, 0, back, side, 0], [0, 1, 2]];
  return signGeometry([
    [...ringMesh(corners, inner - rim, 1 + rim, turn), 0], [...arrow(1.08, 0.31, 1.6), 0],
    [...ringMesh(corners, inner, 1, turn), 1], [...arrow(1.12, 0.23, 1.53), 1]]);
}

function ring(corners, turn) {
  const mesh = new Mesh(ringGeometry(corners, turn),
    signMaterial(kSignVertex, kSignFragment, {uniforms: {tint: new Color(), rim: new Color(1, 1, 1), opacity: 1}, depthTest: false}));
  mesh.renderOrder = 8;
  return mesh;
}

/** A disc of two standard deviations. */
function disc() {
  const mesh = new Mesh(signGeometry([[...ringMesh(0, 0, 1), 1]]),
    signMaterial(kSignVertex, kSignFragment, {uniforms: {tint: new Color(), rim: new Color(), opacity: 0.22}}));
  mesh.renderOrder = 2;
  return mesh;
}

function place(object, matrix) {
  object.matrix.fromArray(matrix);
  object.matrixWorldNeedsUpdate = true;
}

function fixed(...objects) {
  const group = new Group();
  for (const object of objects) object.matrixAutoUpdate = false;
  group.add(...objects);
  return group;
}

/** The true robot. */
class TrueRobot {
  constructor(geometry, light) {
    this.body = new Mesh(geometry, light.material());
    this.ring = ring(0, 0);
    this.group = fixed(this.body, this.ring);
  }

  /** `size` [m]: radius of the ring; null pose: not shown. */
  show(pose, lift, size) {
    this.group.visible = pose !== null;
    if (!pose) return;
    place(this.body, poseMatrix(pose, lift));
    place(this.ring, floorMatrix(pose, kRing + (pose.z ?? 0), size));
  }
}

/** Where a localizer believes that the robot is. */
class Ghost {
  constructor(geometry, light, k, corners, turn) {
    const common = {shared: {eye: light.uniforms.eye}, uniforms: {tint: new Color(), opacity: 0.4}, transparent: true};
    this.body = new Mesh(geometry, material(kLitVertex, kGhostFragment, common));
    // Depth first, so that only the nearest surface of the ghost is seen.
    this.depth = light.plain ? new Group() : new Mesh(geometry, light.depthMaterial({transparent: true}));
    this.ring = ring(corners, turn);
    this.disc = disc();
    this.depth.renderOrder = 4 + 0.2 * k;
    this.body.renderOrder = this.depth.renderOrder + 0.1;
    this.ring.renderOrder += 0.1 * k;
    this.larger = 1.04 + 0.03 * k;  // Around the robot where the two agree.
    this.group = fixed(this.depth, this.body, this.ring, this.disc);
  }

  show(pose, {lift, size, sigma, lost, near}) {
    this.group.visible = pose !== null;
    if (!pose) return;
    const matrix = poseMatrix(pose, lift).map((value, i) => (i < 12 ? this.larger * value : value));
    for (const mesh of [this.depth, this.body]) place(mesh, matrix);
    place(this.ring, floorMatrix(pose, kRing + (pose.z ?? 0), size));
    place(this.disc, floorMatrix(pose, 0.008 + (pose.z ?? 0), Math.max(2 * sigma, 1e-3)));
    this.body.material.uniforms.opacity.value = lost || near ? 0.24 : 0.45;
  }
}

/** `corners`, `turns`: of the rings' outlines by localizer, as on the map. */
export class Robots3d {
  constructor(json, light, names, {corners, turns}) {
    const geometry = geometryOf(unpackMesh(json.robot));
    const thinned = geometryOf(unpackMesh(json.ghost));
    this.truth = new TrueRobot(geometry, light);
    this.ghosts = names.map((_, k) => new Ghost(thinned, light, k, corners[k % corners.length], turns[k % turns.length]));
    this.geometries = [geometry, thinned];
  }

  groups() {
    return [this.truth.group, ...this.ghosts.map((ghost) => ghost.group)];
  }

  addTo(scene) {
    scene.add(...this.groups());
  }

  removeFrom(scene) {
    scene.remove(...this.groups());
    for (const geometry of this.geometries) geometry.dispose();
  }

  /** `tints`: by localizer, [r, g, b] in [0, 1]. */
  recolor(tints, truth) {
    this.truth.ring.material.uniforms.tint.value.setRGB(...truth);
    this.ghosts.forEach((ghost, k) => {
      for (const mesh of [ghost.body, ghost.ring, ghost.disc]) mesh.material.uniforms.tint.value.setRGB(...tints[k]);
    });
  }

  /** Radius of a ring that is seen from far, too. [m] */
  static ringSize(pose, eye, radius) {
    return Math.max(1.35 * radius, kLeastRing * Math.hypot(pose.x - eye[0], pose.y - eye[1], eye[2]));
  }
}
