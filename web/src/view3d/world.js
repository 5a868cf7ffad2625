// The world of the 3-D view: its meshes, and the light in it.
import {
  BufferAttribute, BufferGeometry, DepthTexture, LessEqualCompare, LinearFilter, Matrix4, Mesh, OrthographicCamera, Scene,
  UnsignedIntType, Vector3, Vector4, WebGLRenderTarget,
} from 'three';
import {cornersOf} from './camera.js';
import {floorGeometry, geometryOf, material} from './geometry.js';
import {unpackMesh} from './meshes.js';
import {
  kFillVertex, kLitFragment, kLitVertex, kNothingFragment, kPlainVertex, kSurroundingsFragment, kToSun,
} from './shaders.js';

const kShadowSize = 2048;  // [px]
const kSurroundingsSize = 640;  // [px] Of the longer side.

function depthTarget(width, height) {
  const target = new WebGLRenderTarget(width, height);
  target.depthTexture = new DepthTexture(width, height, UnsignedIntType);
  target.depthTexture.magFilter = target.depthTexture.minFilter = LinearFilter;
  return target;
}

/** A camera along `direction` that sees just these points. */
function cameraOver(points, direction, up) {
  const camera = new OrthographicCamera();
  camera.up.set(...up);
  camera.position.set(0, 0, 0);
  camera.lookAt(new Vector3(...direction));
  camera.updateMatrixWorld();
  const seen = points.map((point) => new Vector3(...point).applyMatrix4(camera.matrixWorldInverse));
  const range = (axis) => [Math.min(...seen.map((p) => p[axis])), Math.max(...seen.map((p) => p[axis]))];
  [camera.left, camera.right] = range('x');
  [camera.bottom, camera.top] = range('y');
  const [far, near] = range('z');
  [camera.near, camera.far] = [-near - 0.05, -far + 0.05];
  camera.updateProjectionMatrix();
  return camera;
}

/** Uniforms of light that all lit materials share. */
export function lightUniforms() {
  const names = {eye: new Vector3(), toSun: new Vector3(...kToSun), brightness: 1, shadowMap: null, shadowFromMap: new Matrix4(),
    shadowTexel: 0.01, surroundings: null, extent: new Vector4(0, 0, 1, 1), top: 1};
  return Object.fromEntries(Object.entries(names).map(([name, value]) => [name, {value}]));
}

export class World3d {
  /** `json`: of the page's scene; `light`: `lightUniforms`. */
  constructor(json, light) {
    this.json = json;
    this.light = light;
    const lit = material(kLitVertex, kLitFragment, {shared: light});
    const floor = new Mesh(floorGeometry(json.extent, json.floor), lit);
    floor.position.z = -0.003;
    this.solid = new Mesh(geometryOf(unpackMesh(json.world)), lit);
    this.meshes = [floor, this.solid];
    const roof = unpackMesh(json.roof);
    this.roof = roof ? new Mesh(geometryOf(roof), lit) : null;
    if (this.roof) {
      this.roof.visible = false;
      this.meshes.push(this.roof);
    }
  }

  addTo(scene) {
    scene.add(...this.meshes);
  }

  removeFrom(scene) {
    scene.remove(...this.meshes);
    for (const mesh of this.meshes) mesh.geometry.dispose();
    for (const target of this.targets ?? []) target.dispose();
  }

  /** Renders shadows and surroundings. */
  bake(renderer) {
    const scene = new Scene();
    const caster = new Mesh(this.solid.geometry,
      material(kPlainVertex, kNothingFragment, {polygonOffset: true, polygonOffsetFactor: 1.5, polygonOffsetUnits: 4}));
    caster.frustumCulled = false;
    scene.add(caster);
    this.targets = [this.bakeShadows(renderer, scene), ...this.bakeSurroundings(renderer, scene)];
    renderer.setRenderTarget(null);
  }

  bakeShadows(renderer, scene) {
    const {light, json} = this;
    const corners = cornersOf(json.extent, json.top + 0.1);
    const camera = cameraOver(corners, kToSun.map((value) => -value), [0, 1, 0]);
    const target = depthTarget(kShadowSize, kShadowSize);
    target.depthTexture.compareFunction = LessEqualCompare;
    renderer.setRenderTarget(target);
    renderer.clear();
    renderer.render(scene, camera);
    light.shadowMap.value = target.depthTexture;
    light.shadowFromMap.value.makeTranslation(0.5, 0.5, 0.5).multiply(new Matrix4().makeScale(0.5, 0.5, 0.5))
      .multiply(camera.projectionMatrix).multiply(camera.matrixWorldInverse);
    light.shadowTexel.value = Math.max(camera.right - camera.left, camera.top - camera.bottom) / kShadowSize;
    return target;
  }

  /** Heights from above, and from these what covers the sky. */
  bakeSurroundings(renderer, scene) {
    const {light, json} = this;
    const [left, bottom, right, upper] = json.extent;
    const top = Math.max(json.top, 0.1);
    const scale = kSurroundingsSize / Math.max(right - left, upper - bottom);
    const size = [right - left, upper - bottom].map((length) => Math.max(1, Math.round(scale * length)));
    const camera = cameraOver(cornersOf(json.extent, top), [0, 0, -1], [0, 1, 0]);
    [camera.near, camera.far] = [-top, 0];
    camera.updateProjectionMatrix();
    const heights = depthTarget(...size);
    renderer.setRenderTarget(heights);
    renderer.clear();
    renderer.render(scene, camera);
    const target = new WebGLRenderTarget(...size);
    const fill = new BufferGeometry();
    fill.setAttribute('position', new BufferAttribute(new Float32Array([-1, -1, 0, 3, -1, 0, -1, 3, 0]), 3));
    const pass = new Mesh(fill, material(kFillVertex, kSurroundingsFragment, {vertexColors: false, depthTest: false,
      uniforms: {heights: heights.depthTexture, size: [right - left, upper - bottom], top}}));
    pass.frustumCulled = false;
    renderer.setRenderTarget(target);
    renderer.render(pass, camera);
    light.surroundings.value = target.texture;
    light.extent.value.set(...json.extent);
    light.top.value = top;
    return [heights, target];
  }
}
