// The player: map, time, curves and what is said, all at one time.
import {Curves} from './curves.js';
import {help, layerChoices, mapButtons, transport} from './controls.js';
import {element} from './dom.js';
import {actionOf, ownsKey} from './keys.js';
import {errorLegend, mapLegend, timeLegend} from './legend.js';
import {MapView} from './map_view.js';
import {Views} from './view3d/views.js';
import {marksOf} from './marks.js';
import {hasTruth} from './measures.js';
import {palette} from './palette.js';
import {Panel} from './panel.js';
import {Playback} from './playback.js';
import {Timeline} from './timeline.js';
import {boundsOf} from './view.js';

const kAnywhere = new Set([' ', 'k', 'ArrowLeft', 'ArrowRight']);

/** Width over height of the map, as far as a window can follow it. */
function aspectOf(map) {
  const {left, right, bottom, top} = boundsOf(map);
  return Math.min(3, Math.max(0.9, (right - left + 0.5) / (top - bottom + 0.5)));
}

/** `run`: {recording, errors, states, events, limits}; puts itself into the two places. */
export class Player {
  constructor(place, curvesPlace, run) {
    this.place = place;
    this.run = run;
    this.state = {
      time: run.recording.time[0] ?? 0, of: -1, scanAt: -1, errorOf: -1, level: -1, follow: false,
      show: new Set(['truth', 'estimates', 'particles', 'scan', 'people', 'trails']),
    };
    this.colors = palette();
    const colors = () => this.colors;
    const act = (action, argument) => this.act(action, argument);
    const seek = (time) => this.act('seek', time);
    const marks = marksOf(run.events);
    this.stops = marks.map((mark) => mark.time);
    this.playback = new Playback(Array.from(run.recording.time), () => this.changed());
    this.build(act, marks);
    this.timeline = new Timeline(this.timePlace, run, marks, colors, seek);
    this.curves = new Curves(this.curvePlace, curvesPlace, run, marks, colors, seek);
    this.recolor();
    document.addEventListener('keydown', (event) => this.key(event));
  }

  build(act, marks) {
    const {recording, events} = this.run;
    const canvas = element('canvas', {class: 'map', tabindex: 0, role: 'img',
      'aria-label': 'Map with the robot, its estimates, particles, scan and people'});
    this.mapView = new MapView(canvas, recording, events, this.state);
    if (hasTruth(recording)) this.mapView.errors = this.run.errors;
    else delete this.state.errorOf;
    this.mapView.onMoved = () => this.buttons.show(this.state.follow);
    this.views = new Views(this.mapView, recording, events, this.state, () => this.changed(),
      'drag: turn · right button or two fingers: move · wheel: nearer');
    this.buttons = mapButtons(act, this.views.above);
    this.transport = transport(act);
    this.timePlace = element('div', {class: 'timeline'});
    this.curvePlace = element('div', {class: 'curve'});
    const cards = element('div', {class: 'cards'});
    this.panel = new Panel(cards, this.run);
    this.errorLegend = errorLegend();
    const side = element('div', {class: 'side'}, cards,
      layerChoices(this.state, recording.names, act, recording.header.levels?.z_m));
    this.views.setScene(this.run.scene);
    canvas.style.aspectRatio = aspectOf(recording.header.levels?.map ?? recording.header.map);
    this.place.append(
      element('div', {class: 'map-frame'}, canvas, ...this.views.parts, this.buttons.row), side, this.errorLegend,
      this.transport.row, this.timePlace, timeLegend(marks), this.curvePlace, mapLegend(), help());
  }

  recolor() {
    this.colors = palette();
    this.views.setColors(this.colors);
    this.panel.recolor(this.colors);
    this.timeline.draw();
    this.curves.redraw();
    this.changed();
  }

  /** Something changed: all of it is drawn with the next frame. */
  changed() {
    if (this.asked) return;
    this.asked = true;
    requestAnimationFrame((now) => this.frame(now));
  }

  frame(now) {
    this.asked = false;
    const elapsed = this.playback.playing && this.last ? Math.min(0.25, (now - this.last) / 1000) : 0;
    this.last = this.playback.playing ? now : null;
    if (this.playback.playing) {
      this.playback.advance(elapsed);
      this.changed();
    }
    this.show();
  }

  show() {
    const {time} = this.playback;
    this.state.time = time;
    const scan = this.run.recording.scanAt(time);
    this.views.draw();
    this.errorLegend.hidden = !(this.state.errorOf >= 0);
    this.buttons.show(this.state.follow);
    this.transport.show(this.playback);
    this.timeline.show(time, scan);
    this.panel.show(scan);
    this.curves.show(time, scan);
    this.place.dataset.time = time.toFixed(4);
  }

  act(action, argument) {
    const {playback, views, state} = this;
    const acts = {
      toggle: () => playback.toggle(),
      seek: () => playback.seek(argument),
      skip: () => playback.seek(playback.time + argument),
      step: () => playback.step(argument),
      jump: () => playback.jump(this.stops, argument),
      faster: () => playback.faster(argument),
      speed: () => playback.setSpeed(argument),
      zoom: () => views.zoom(argument),
      fit: () => views.fit(),
      top: () => views.top(),
      toggle3d: () => views.toggle(),
      follow: () => this.follow(!state.follow),
      draw: () => {},
    };
    acts[action]();
    this.changed();
  }

  /** Follows the robot from near. */
  follow(on) {
    this.state.follow = on;
    const {view} = this.mapView;
    if (on && view) this.mapView.view = {...view, scale: Math.max(view.scale, view.height / 8)};
  }

  key(event) {
    const focused = document.activeElement;
    const inside = this.place.contains(focused);
    if (!inside && !(focused === document.body && kAnywhere.has(event.key))) return;
    if (ownsKey(focused, event.key)) return;
    const action = actionOf(event);
    if (!action) return;
    event.preventDefault();
    this.act(...action);
  }
}
