// The world of the 3-D view: its meshes, and the light in it.
import {
  BufferAttribute, BufferGeometry, DepthTexture, LessEqualCompare, LinearFilter, LinearMipmapNearestFilter, Matrix4, Mesh, NearestFilter, OrthographicCamera,
  Scene, UnsignedIntType, Vector3, WebGLRenderTarget,
} from 'three';
import {cornersOf} from './camera.js';
import {floorGeometry, geometryOf, material} from './geometry.js';
import {unpackMesh} from './meshes.js';
import {
  kFillVertex, kFloorFragment, kFloorVertex, kNothingFragment, kPlainVertex, kSurroundingsFragment, kToSun,
} from './shaders.js';

const kShadowSize = 2048;  // [px]
const kFloorSize = 2048;  // [px] Of the longer side.
const kFloor = -0.003;  // [m] Height, as in the pictures.
const kSurroundingsSize = 640;  // [px] Of the longer side.

/** A target of which the depth is a texture; depths are not filtered without comparing them. */
function depthTarget(width, height, filter = NearestFilter) {
  const target = new WebGLRenderTarget(width, height);
  target.depthTexture = new DepthTexture(width, height, UnsignedIntType);
  target.depthTexture.magFilter = target.depthTexture.minFilter = filter;
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

export class World3d {
  /** `json`: of the page's scene. */
  constructor(json, light) {
    this.json = json;
    this.light = light;
    const lit = light.material();
    this.floor = new Mesh(floorGeometry(json.extent, json.floor), material(kFloorVertex, kFloorFragment,
      {vertexColors: false, shared: {brightness: light.uniforms.brightness}, uniforms: {picture: null}}));
    this.floor.position.z = kFloor;
    this.floor.renderOrder = 0.5;  // Most of it is hidden by what stands on it.
    this.solid = new Mesh(geometryOf(unpackMesh(json.world)), lit);
    this.meshes = [this.floor, this.solid];
    if (!light.plain) this.addDepth();
    const roof = unpackMesh(json.roof);
    this.roof = roof ? new Mesh(geometryOf(roof), lit) : null;
    if (this.roof) {
      this.roof.visible = false;
      this.meshes.push(this.roof);
    }
  }

  /** Draws depths first, so that hidden surfaces are not lit. */
  addDepth() {
    const depth = new Mesh(this.solid.geometry, this.light.depthMaterial());
    depth.renderOrder = -1;
    this.meshes.push(depth);
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
    this.targets = [this.bakeShadows(renderer, scene), ...this.bakeSurroundings(renderer, scene), this.bakeFloor(renderer)];
    renderer.setRenderTarget(null);
  }

  bakeShadows(renderer, scene) {
    const {light, json} = this;
    const corners = cornersOf(json.extent, json.top + 0.1);
    const camera = cameraOver(corners, kToSun.map((value) => -value), [0, 1, 0]);
    const target = depthTarget(kShadowSize, kShadowSize, LinearFilter);
    target.depthTexture.compareFunction = LessEqualCompare;
    renderer.setRenderTarget(target);
    renderer.clear();
    renderer.render(scene, camera);
    light.set('shadowMap', target.depthTexture);
    light.uniforms.shadowFromMap.value.makeTranslation(0.5, 0.5, 0.5).multiply(new Matrix4().makeScale(0.5, 0.5, 0.5))
      .multiply(camera.projectionMatrix).multiply(camera.matrixWorldInverse);
    light.set('shadowTexel', Math.max(camera.right - camera.left, camera.top - camera.bottom) / kShadowSize);
    return target;
  }

  /** Heights from above, and from these what covers the sky. */
  bakeSurroundings(renderer, scene) {
    const {light, json} = this;
    const [left, bottom, right, upper] = json.extent;
    const top = Math.max(json.top, 0.1);
    const size = this.pixels(kSurroundingsSize);
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
    light.set('surroundings', target.texture);
    light.uniforms.extent.value.set(...json.extent);
    light.set('top', top);
    return [heights, target];
  }

  /** The floor as it is lit. */
  bakeFloor(renderer) {
    const {light, json, floor} = this;
    const target = new WebGLRenderTarget(...this.pixels(kFloorSize),
      {generateMipmaps: true, minFilter: LinearMipmapNearestFilter, depthBuffer: false});
    const lit = new Mesh(floor.geometry, light.material({}, false));
    lit.position.z = kFloor;
    const brightness = light.uniforms.brightness.value;
    light.set('brightness', 1);
    light.eye.set(0, 0, 1e4);
    renderer.setRenderTarget(target);
    renderer.render(lit, cameraOver(cornersOf(json.extent, 0.1), [0, 0, -1], [0, 1, 0]));
    light.set('brightness', brightness);
    floor.material.uniforms.picture.value = target.texture;
    return target;
  }

  /** Size of a picture of the floor whose longer side has `most` pixels. */
  pixels(most) {
    const [left, bottom, right, upper] = this.json.extent;
    const scale = most / Math.max(right - left, upper - bottom);
    return [right - left, upper - bottom].map((length) => Math.max(1, Math.round(scale * length)));
  }
}
