// Light of the 3-D view, as materials need it.
import {Matrix4, Vector3, Vector4} from 'three';
import {material} from './geometry.js';
import {kDepthFragment, kLitFragment, kLitVertex, kToSun} from './shaders.js';

/** Values that all lit materials share. `plain`: without shadows and occlusion on what stands on the floor. */
export class Light {
  constructor(plain) {
    const values = {eye: new Vector3(), toSun: new Vector3(...kToSun), brightness: 1, shadowMap: null,
      shadowFromMap: new Matrix4(), shadowTexel: 0.01, surroundings: null, extent: new Vector4(0, 0, 1, 1), top: 1, ceiling: 1e6};
    this.uniforms = Object.fromEntries(Object.entries(values).map(([name, value]) => [name, {value}]));
    this.plain = plain;
  }

  set(name, value) {
    this.uniforms[name].value = value;
  }

  get eye() {
    return this.uniforms.eye.value;
  }

  material(more = {}, plain = this.plain) {
    return material(kLitVertex, kLitFragment, {shared: this.uniforms, defines: plain ? {PLAIN: ''} : {}, ...more});
  }

  /** Writes the depth of what has the material above. */
  depthMaterial(more = {}) {
    return material(kLitVertex, kDepthFragment, {shared: {ceiling: this.uniforms.ceiling}, colorWrite: false, ...more});
  }
}
