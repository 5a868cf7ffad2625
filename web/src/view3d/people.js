// People of the 3-D view, built as sim/people/bodies/person_visuals.cpp builds them.
import {Color, FrontSide, InstancedMesh, Matrix4, Quaternion, Vector3} from 'three';
import {partsOf} from './gait.js';
import {geometryOf} from './geometry.js';
import {unpackMesh} from './meshes.js';

const kUp = new Vector3(0, 0, 1);
const kMost = 512;

/** `count` copies of a part for each person. */
const kParts = {shoe: 2, shin: 2, thigh: 2, coat: 1, head: 1};

export class People3d {
  constructor(model, light) {
    this.model = model;
    const lit = light.material({side: FrontSide});
    this.parts = {};
    for (const [name, count] of Object.entries(kParts)) {
      const mesh = new InstancedMesh(geometryOf(unpackMesh(model[name])), lit, count * kMost);
      mesh.frustumCulled = false;
      mesh.count = 0;
      mesh.setColorAt(0, new Color(1, 1, 1));
      this.parts[name] = mesh;
    }
    this.matrix = new Matrix4();
    this.turn = new Quaternion();
    this.color = new Color();
  }

  addTo(scene) {
    scene.add(...Object.values(this.parts));
  }

  removeFrom(scene) {
    for (const mesh of Object.values(this.parts)) {
      scene.remove(mesh);
      mesh.geometry.dispose();
      mesh.dispose();
    }
  }

  put(name, position, yaw, scale, color) {
    const mesh = this.parts[name];
    if (mesh.count >= kMost * kParts[name]) return;
    this.turn.setFromAxisAngle(kUp, yaw);
    this.matrix.compose(new Vector3(...position), this.turn, new Vector3(...scale));
    mesh.setMatrixAt(mesh.count, this.matrix);
    mesh.setColorAt(mesh.count, this.color.setRGB(...color));
    ++mesh.count;
  }

  /** From a knee to a hip. */
  putThigh(knee, hip, girth, color) {
    const mesh = this.parts.thigh;
    const way = new Vector3(hip[0] - knee[0], hip[1] - knee[1], hip[2] - knee[2]);
    const length = way.length();
    this.turn.setFromUnitVectors(kUp, way.divideScalar(length));
    this.matrix.compose(new Vector3(...knee), this.turn, new Vector3(girth, girth, length));
    mesh.setMatrixAt(mesh.count, this.matrix);
    mesh.setColorAt(mesh.count, this.color.setRGB(...color));
    ++mesh.count;
  }

  add(person) {
    const {model} = this;
    const {x, y, yaw, id} = person;
    const [coat, trousers] = model.clothes[id % model.clothes.length];
    const {feet, hips, girth, coat: [base, stretch], head} = partsOf(model, person);
    feet.forEach((foot, side) => {
      this.put('shoe', [...foot, 0], yaw, [1, 1, 1], [1, 1, 1]);
      this.put('shin', [...foot, 0], yaw, [girth, girth, 1], trousers);
      this.putThigh([...foot, model.torso_bottom], hips[side], girth, trousers);
    });
    this.put('coat', [x, y, base], yaw, [1, 1, stretch], coat);
    this.put('head', [x, y, head], yaw, [1, 1, 1], [1, 1, 1]);
  }

  show(people) {
    for (const mesh of Object.values(this.parts)) mesh.count = 0;
    for (const person of people.slice(0, kMost)) this.add(person);
    for (const mesh of Object.values(this.parts)) {
      mesh.instanceMatrix.needsUpdate = true;
      mesh.instanceColor.needsUpdate = true;
    }
  }
}
