// The canvas with the map: its size, what hands and wheels do to it, and when it is drawn.
import {drawErrors} from './error_layer.js';
import {drawMap, drawScaleBar} from './ground.js';
import * as layers from './layers.js';
import {floorOf} from './levels.js';
import {mapCanvas} from './map_image.js';
import {poseAt} from './poses.js';
import {boundsOf, fitted, panned, resized, toMap, zoomed} from './view.js';

/** The map on a canvas. `state`: {time, show, of, scanAt, errorOf, follow}, changed from outside. */
export class MapView {
  constructor(canvas, recording, events, state) {
    this.canvas = canvas;
    this.context = canvas.getContext('2d');
    this.recording = recording;
    this.events = events;
    this.state = state;
    this.fingers = new Map();
    this.view = null;
    this.isWhole = true;  // Nobody has moved it.
    this.onMoved = () => {};
    this.errors = null;  // Of the localizers, as measures.js has them: colours of the path.
    // A hand: {grab(point, view) -> {move(point), drop(point)} or null, draw(context, scene)}.
    this.hand = null;
    this.held = null;
    new ResizeObserver(() => this.resize()).observe(canvas);
    canvas.addEventListener('wheel', (event) => this.wheel(event), {passive: false});
    canvas.addEventListener('pointerdown', (event) => this.down(event));
    canvas.addEventListener('pointermove', (event) => this.move(event));
    for (const name of ['pointerup', 'pointercancel']) {
      canvas.addEventListener(name, (event) => this.up(event, name === 'pointerup'));
    }
  }

  setColors(colors) {
    this.colors = colors;
    this.images = new Map();  // By section.
  }

  resize() {
    const {clientWidth: width, clientHeight: height} = this.canvas;
    if (!width || !height) return;
    this.ratio = window.devicePixelRatio || 1;
    this.canvas.width = Math.round(width * this.ratio);
    this.canvas.height = Math.round(height * this.ratio);
    this.view = this.isWhole ? this.whole(width, height) : resized(this.view, width, height);
    this.draw();
  }

  whole(width, height) {
    return fitted(boundsOf(this.recording.header.levels?.map ?? this.recording.header.map), width, height);
  }

  /** The picture of the map or of a floor. */
  imageOf({map, section}) {
    if (!this.images.has(section)) this.images.set(section, mapCanvas(this.recording, this.colors, map, section));
    return this.images.get(section);
  }

  fit() {
    this.view = this.whole(this.view.width, this.view.height);
    this.state.follow = false;
    this.moved();
    this.isWhole = true;
  }

  zoom(factor, px, py) {
    this.view = zoomed(this.view, factor, px, py);
    this.moved();
  }

  moved() {
    this.isWhole = false;
    this.onMoved();
    this.draw();
  }

  wheel(event) {
    event.preventDefault();
    const box = this.canvas.getBoundingClientRect();
    this.zoom(1.0015 ** -event.deltaY, event.clientX - box.left, event.clientY - box.top);
  }

  /** The point in map under a pointer. */
  pointAt(event) {
    const box = this.canvas.getBoundingClientRect();
    return toMap(this.view, event.clientX - box.left, event.clientY - box.top);
  }

  down(event) {
    this.canvas.setPointerCapture(event.pointerId);
    const grip = this.fingers.size === 0 && this.view ? this.hand?.grab(this.pointAt(event), this.view) : null;
    if (grip) {
      this.held = {grip, id: event.pointerId};
      return;
    }
    this.fingers.set(event.pointerId, [event.clientX, event.clientY]);
  }

  up(event, done) {
    this.fingers.delete(event.pointerId);
    if (this.held?.id !== event.pointerId) return;
    const {grip} = this.held;
    this.held = null;
    if (done) grip.drop(this.pointAt(event));
    this.draw();
  }

  /** One finger moves the map, two also zoom it. */
  move(event) {
    if (this.held?.id === event.pointerId) {
      this.held.grip.move(this.pointAt(event));
      this.draw();
      return;
    }
    const before = this.fingers.get(event.pointerId);
    if (!before) return;
    const now = [event.clientX, event.clientY];
    const other = [...this.fingers].find(([id]) => id !== event.pointerId)?.[1];
    this.fingers.set(event.pointerId, now);
    const share = other ? 0.5 : 1;
    this.state.follow = false;
    this.view = panned(this.view, share * (now[0] - before[0]), share * (now[1] - before[1]));
    if (other) {
      const length = (p) => Math.max(10, Math.hypot(p[0] - other[0], p[1] - other[1]));
      const box = this.canvas.getBoundingClientRect();
      this.view = zoomed(this.view, length(now) / length(before),
        (now[0] + other[0]) / 2 - box.left, (now[1] + other[1]) / 2 - box.top);
    }
    this.moved();
  }

  /** What is to be drawn now. */
  scene() {
    const {recording, state} = this;
    const scan = recording.scanAt(state.time);
    const track = recording.truth.known[scan] ? recording.truth : recording.localizers[0];
    const pose = state.follow && track ? poseAt(track, recording.time, scan, state.time) : null;
    if (pose) {
      this.view = {...this.view, x: pose.x, y: pose.y};
      this.isWhole = false;
    }
    const floor = floorOf(state, recording, scan);
    return {
      recording, view: this.view, colors: this.colors, time: state.time, scan,
      detail: recording.detailAt(scan), show: state.show, of: state.of, scanAt: state.scanAt,
      errors: this.errors, errorOf: state.errorOf ?? -1,
      events: this.events, live: state.live, map: floor.map, mapCanvas: this.imageOf(floor), onLevel: floor.onLevel,
    };
  }

  draw() {
    if (!this.view || !this.colors) return;
    const scene = this.scene();
    const {context} = this;
    context.setTransform(this.ratio, 0, 0, this.ratio, 0, 0);
    drawMap(context, scene);
    if (this.recording.scans) this.drawRun(context, scene);
    this.hand?.draw(context, scene);
    drawScaleBar(context, scene);
  }

  drawRun(context, scene) {
    const {show} = scene;
    layers.drawWorld(context, scene);
    drawErrors(context, scene);
    if (show.has('paths')) layers.drawPaths(context, scene, true);
    if (show.has('trails')) layers.drawPaths(context, scene, false);
    if (show.has('particles')) layers.drawParticles(context, scene);
    if (show.has('scan')) layers.drawScan(context, scene);
    if (show.has('people')) layers.drawPeople(context, scene);
    layers.drawKidnaps(context, scene);
    if (show.has('truth')) layers.drawTruth(context, scene);
    if (show.has('estimates')) layers.drawEstimates(context, scene);
  }
}
