// People of the 3-D view, built as sim/people/bodies/person_visuals.cpp builds them.
import {Color, FrontSide, InstancedMesh, Matrix4, Quaternion, Vector3} from 'three';
import {partsOf} from './gait.js';
import {geometryOf} from './geometry.js';
import {unpackMesh} from './meshes.js';

const kUp = new Vector3(0, 0, 1);
const kMost = 512;
const kNear = 4.5;  // [m] From the eye: nearer people are drawn finer.

/** `count` copies of a part for each person. */
const kParts = {shoe: 2, shin: 2, thigh: 2, coat: 1, head: 1};

/** Copies of the parts of people: finer or coarser ones. */
class Parts {
  constructor(model, lit) {
    this.meshes = {};
    for (const [name, count] of Object.entries(kParts)) {
      const mesh = new InstancedMesh(geometryOf(unpackMesh(model[name])), lit, count * kMost);
      mesh.frustumCulled = false;
      mesh.setColorAt(0, new Color(1, 1, 1));
      this.meshes[name] = mesh;
    }
    this.matrix = new Matrix4();
    this.turn = new Quaternion();
    this.color = new Color();
    this.clear();
  }

  all() {
    return Object.values(this.meshes);
  }

  clear() {
    for (const mesh of this.all()) mesh.count = 0;
  }

  done() {
    for (const mesh of this.all()) {
      mesh.visible = mesh.count > 0;
      mesh.instanceMatrix.needsUpdate = true;
      mesh.instanceColor.needsUpdate = true;
    }
  }

  put(name, position, turn, scale, color) {
    const mesh = this.meshes[name];
    this.matrix.compose(new Vector3(...position), turn, new Vector3(...scale));
    mesh.setMatrixAt(mesh.count, this.matrix);
    mesh.setColorAt(mesh.count, this.color.setRGB(...color));
    ++mesh.count;
  }

  /** From a knee to a hip. */
  putThigh(knee, hip, girth, color) {
    const way = new Vector3(...hip).sub(new Vector3(...knee));
    const length = way.length();
    this.put('thigh', knee, this.turn.setFromUnitVectors(kUp, way.divideScalar(length)), [girth, girth, length], color);
  }

  add(model, person) {
    const {x, y, yaw, id} = person;
    const [coat, trousers] = model.clothes[id % model.clothes.length];
    const {feet, hips, girth, coat: [base, stretch], head} = partsOf(model, person);
    const turn = new Quaternion().setFromAxisAngle(kUp, yaw);
    feet.forEach((foot, side) => {
      this.put('shoe', [...foot, 0], turn, [1, 1, 1], [1, 1, 1]);
      this.put('shin', [...foot, 0], turn, [girth, girth, 1], trousers);
      this.putThigh([...foot, model.torso_bottom], hips[side], girth, trousers);
    });
    this.put('coat', [x, y, base], turn, [1, 1, stretch], coat);
    this.put('head', [x, y, head], turn, [1, 1, 1], [1, 1, 1]);
  }
}

export class People3d {
  constructor(model, light) {
    this.model = model;
    const lit = light.material({side: FrontSide});
    this.near = new Parts(model.near, lit);
    this.far = new Parts(model.far, lit);
  }

  all() {
    return [...this.near.all(), ...this.far.all()];
  }

  addTo(scene) {
    scene.add(...this.all());
  }

  removeFrom(scene) {
    scene.remove(...this.all());
    for (const mesh of this.all()) {
      mesh.geometry.dispose();
      mesh.dispose();
    }
  }

  /** `eye`: where they are seen from. [m] */
  show(people, eye) {
    for (const parts of [this.near, this.far]) parts.clear();
    for (const person of people.slice(0, kMost)) {
      const distance = Math.hypot(person.x - eye[0], person.y - eye[1], 1 - eye[2]);
      (distance < kNear ? this.near : this.far).add(this.model, person);
    }
    for (const parts of [this.near, this.far]) parts.done();
  }
}
