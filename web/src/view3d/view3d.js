// The 3-D view on a canvas: its size, its camera, and when it is drawn.
import {ColorManagement, LinearSRGBColorSpace, PerspectiveCamera, Scene, WebGLRenderer} from 'three';
import {element} from '../dom.js';
import {floorOf} from '../levels.js';
import {poseAt} from '../poses.js';
import {rgb, styleOf} from '../palette.js';
import * as cameras from './camera.js';
import {Content3d} from './content.js';
import {Hands3d} from './hands3d.js';
import {Light} from './light.js';
import {freeDistance, occupiedCells} from './obstacles.js';
import {Pace} from './pace.js';

const kEase = 0.13;  // [s] In which a camera goes most of its way.
const kMostRatio = 2;  // Of the canvas's pixels to the page's.
const kRest = 200;  // [ms] After which a picture stands still.
const kRow = 19;  // [px] Of a label.
const kDay = [0.93, 0.95, 0.97];  // Background, as in the pictures.

ColorManagement.enabled = false;  // Colours are those of the pictures, to the number.

/** True where the processor draws: smooth edges and shadows would cost too much. */
function isSoftware() {
  const context = document.createElement('canvas').getContext('webgl2');
  const names = context?.getExtension('WEBGL_debug_renderer_info');
  const name = names ? context.getParameter(names.UNMASKED_RENDERER_WEBGL) : '';
  context?.getExtension('WEBGL_lose_context')?.loseContext();
  return /swiftshader|llvmpipe|software|basic render/i.test(name);
}

/** A context of WebGL 2; null where the browser has none. */
function contextOf(canvas, plain) {
  return canvas.getContext('webgl2', {alpha: false, antialias: !plain, preserveDrawingBuffer: true});
}

/** Where above `py` a label at `px` hides none of those `taken`; it is added to them. [px] */
function freeRow(taken, px, py) {
  const hides = ([x, y]) => Math.abs(x - px) < 110 && Math.abs(y - py) < kRow;
  for (let other = taken.find(hides); other; other = taken.find(hides)) py = other[1] - kRow;
  taken.push([px, py]);
  return py;
}

/** `state`: {time, show, of, scanAt, follow, live}; `changed()`: asks for `draw` with the next picture of the screen. */
export class View3d {
  constructor(canvas, recording, events, state, changed) {
    Object.assign(this, {canvas, recording, events, state, changed});
    this.labels = element('div', {class: 'labels-3d', 'aria-hidden': 'true'});
    this.light = new Light(isSoftware());
    this.scene = new Scene();
    this.scene.matrixWorldAutoUpdate = true;
    this.lens = new PerspectiveCamera(cameras.kFovDeg, 1, 0.05, 400);
    this.lens.up.set(0, 0, 1);
    this.chase = {...cameras.kFollowing};
    this.still = matchMedia('(prefers-reduced-motion: reduce)');
    this.drawn = 0;
    this.pace = new Pace();
    this.scale = 1;
    new Hands3d(canvas, {orbit: (right, up) => this.orbit(right, up), drag: (dx, dy) => this.drag(dx, dy),
      zoom: (factor) => this.zoom(factor)});
    new ResizeObserver(() => this.resize()).observe(canvas);
  }

  /** Takes what can be seen: JSON of tools/build/scene/page_scene.hpp. False where there is no WebGL. */
  setScene(json) {
    if (!this.renderer && !this.start()) return false;
    this.content?.remove();
    this.content = new Content3d(json, this.recording.names, this.scene, this.light);
    this.content.world.bake(this.renderer);
    this.json = json;
    if (this.colors) this.content.recolor(this.colors);
    this.cells = new Map();  // Occupied ones of each floor, by section.
    this.resize();
    return true;
  }

  start() {
    const context = contextOf(this.canvas, this.light.plain);
    if (!context) return false;
    this.renderer = new WebGLRenderer({canvas: this.canvas, context});
    this.renderer.outputColorSpace = LinearSRGBColorSpace;
    this.renderer.autoClear = true;
    return true;
  }

  get hasRoof() {
    return Boolean(this.content?.world.roof);
  }

  showRoof(on) {
    if (this.content?.world.roof) this.content.world.roof.visible = on;
    this.changed();
  }

  setColors(colors) {
    this.colors = colors;
    const page = rgb(colors.page).map((value) => value / 255);
    const dark = page[0] + page[1] + page[2] < 1.5;
    this.background = dark ? page : kDay;
    this.light.set('brightness', dark ? 0.86 : 1);
    this.content?.recolor(colors);
  }

  resize() {
    const {clientWidth: width, clientHeight: height} = this.canvas;
    if (!width || !height || !this.renderer) return;
    this.ratio = this.scale * Math.min(kMostRatio, window.devicePixelRatio || 1);
    this.renderer.setPixelRatio(this.ratio);
    this.renderer.setSize(width, height, false);
    [this.width, this.height] = [width, height];
    this.goal ??= this.whole();
    this.changed();
  }

  /** Draws with this share of the pixels in each direction. */
  setScale(scale) {
    if (scale === this.scale) return;
    this.scale = scale;
    this.resize();
  }

  /** Where pictures come too slowly they are coarser, until nothing moves any more. */
  keepPace() {
    this.setScale(this.pace.add(performance.now()));
    clearTimeout(this.rest);
    if (this.scale === 1) return;
    this.rest = setTimeout(() => {
      this.pace.rest();
      this.setScale(1);
    }, kRest);
  }

  whole() {
    return cameras.overview(this.json.extent, this.json.top, this.width / this.height);
  }

  /** The whole world from the south, or from straight above. */
  fit(above = false) {
    this.state.follow = false;
    if (this.width) this.goal = above ? cameras.fromAbove(this.json.extent, this.json.top, this.width / this.height) : this.whole();
    this.changed();
  }

  orbit(right, up) {
    if (this.state.follow) this.chase = cameras.orbited(this.chase, right, up);
    else this.jump(cameras.orbited(this.goal, right, up));
    this.changed();
  }

  drag(dx, dy) {
    if (this.state.follow) this.goal = this.shown;
    this.state.follow = false;
    this.jump(cameras.dragged(this.goal, dx, dy, this.height));
    this.changed();
  }

  zoom(factor) {
    if (this.state.follow) this.chase = cameras.closer(this.chase, factor);
    else this.goal = cameras.closer(this.goal, factor);
    this.changed();
  }

  /** A hand is followed at once. */
  jump(camera) {
    this.goal = camera;
    this.shown = camera;
  }

  /** What there is to see now. */
  moment() {
    const {recording, state} = this;
    const scan = recording.scanAt(state.time);
    return {recording, time: state.time, scan, detail: recording.detailAt(scan), show: state.show, of: state.of,
      scanAt: state.scanAt, events: this.events, live: state.live};
  }

  cellsOf({map, section}) {
    if (!this.cells.has(section)) this.cells.set(section, occupiedCells(this.recording.sections.get(section), map));
    return this.cells.get(section);
  }

  /** Moves the camera; true while it is on its way. */
  moveCamera(moment) {
    const {recording, state} = this;
    const pose = state.live?.truth ?? (recording.scans ? poseAt(recording.truth, recording.time, moment.scan, moment.time) : null);
    const floor = floorOf(state, recording, moment.scan);
    this.light.set('ceiling', Math.min(floor.ceiling, 1e6));
    if (state.follow && pose) {
      const behind = pose.yaw + this.chase.azimuth + Math.PI;
      const free = freeDistance(floor.map, this.cellsOf(floor), pose, behind, 8) - 0.15;
      this.goal = cameras.following(this.chase, pose, free);
    }
    const now = performance.now();
    const elapsed = Math.min(0.06, (now - (this.movedAt ?? now - 16)) / 1000);
    this.movedAt = now;
    this.shown = !this.shown || this.still.matches ? this.goal : cameras.eased(this.shown, this.goal, 1 - Math.exp(-elapsed / kEase));
    const moving = this.shown !== this.goal;
    if (!moving) this.movedAt = undefined;
    return moving;
  }

  setLens() {
    const {lens, shown} = this;
    lens.aspect = this.width / this.height;
    lens.near = Math.max(0.05, 0.02 * shown.distance);
    lens.far = 6 * shown.distance + 60;
    lens.position.set(...cameras.eyeOf(shown));
    lens.lookAt(...shown.target);
    lens.updateProjectionMatrix();
    this.light.eye.copy(lens.position);
  }

  draw() {
    if (!this.content || !this.width || !this.colors) return;
    this.keepPace();
    const moment = this.moment();
    const moving = this.moveCamera(moment);
    this.setLens();
    this.content.show(moment, cameras.eyeOf(this.shown), this.ratio);
    this.renderer.setClearColor(`rgb(${this.background.map((value) => Math.round(255 * value))})`);
    this.renderer.render(this.scene, this.lens);
    this.showLabels();
    this.canvas.dataset.drawn = ++this.drawn;  // For who looks at the page from outside: tests.
    if (moving) this.changed();
  }

  /** The localizers' names over their ghosts. */
  showLabels() {
    const {names} = this.recording;
    while (this.labels.childElementCount < names.length) {
      this.labels.append(element('span', {}, names[this.labels.childElementCount]));
    }
    for (const label of this.labels.children) label.hidden = true;
    const taken = [];
    for (const {k, at, lost} of this.content.labels) {
      const place = cameras.inPicture(this.shown, at, this.width / this.height);
      if (!place || Math.max(Math.abs(place[0]), Math.abs(place[1])) > 1) continue;
      const label = this.labels.children[k];
      const [px, py] = [(0.5 + 0.5 * place[0]) * this.width, (0.5 - 0.5 * place[1]) * this.height];
      const y = freeRow(taken, px, py);
      label.hidden = false;
      label.textContent = lost ? `${names[k]} ?` : names[k];
      label.style.setProperty('--own', `var(--c${styleOf(names, k)})`);
      label.style.transform = `translate(${px.toFixed(1)}px, ${y.toFixed(1)}px)`;
    }
  }
}
