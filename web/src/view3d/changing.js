// Objects of the 3-D view that events of the run change: boxes, and doors.
import {Mesh} from 'three';
import {changesSoFar} from '../world_changes.js';
import {geometryOf} from './geometry.js';
import {unpackMesh} from './meshes.js';

export class Changing3d {
  /** `json`: `changing` of the page's scene: looks by name, the first one and one after each change; undefined: none. */
  constructor(json, light) {
    this.looks = Object.entries(json ?? {}).map(([name, meshes]) => ({name, meshes: meshes.map((mesh) => {
      const unpacked = unpackMesh(mesh);
      return unpacked ? new Mesh(geometryOf(unpacked), light.material()) : null;
    })}));
  }

  get meshes() {
    return this.looks.flatMap(({meshes}) => meshes.filter(Boolean));
  }

  addTo(scene) {
    for (const mesh of this.meshes) scene.add(mesh);
  }

  removeFrom(scene) {
    for (const mesh of this.meshes) {
      scene.remove(mesh);
      mesh.geometry.dispose();
    }
  }

  show(changes, time) {
    for (const {name, meshes} of this.looks) {
      const index = Math.min(changesSoFar(changes, name, time), meshes.length - 1);
      meshes.forEach((mesh, i) => {
        if (mesh) mesh.visible = i === index;
      });
    }
  }
}
