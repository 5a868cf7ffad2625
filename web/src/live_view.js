// The page of a live run: map, states, time, tools, and what happened.
import {layerChoices, mapButtons} from './controls.js';
import {clockText, element} from './dom.js';
import {LiveDrive} from './live_drive.js';
import {MapHand} from './live_hands.js';
import {LiveRecording} from './live_recording.js';
import {liveTools} from './live_tools.js';
import {mapLegend} from './legend.js';
import {MapView} from './map_view.js';
import {errorsOf, statesOf} from './measures.js';
import {palette} from './palette.js';
import {Panel} from './panel.js';

const kRight = {m: 0.5, rad: 0.35};  // As the metrics have it.
const kSpeeds = [0.1, 0.25, 0.5, 1, 2, 5, 10, 20, 50, 100];

const poseOf = (pose) => (pose ? {x: pose[0], y: pose[1], yaw: pose[2]} : null);

/** Errors and states of the newest scan only, at its place, as `Panel` reads them. */
class NewestStates {
  constructor(recording) {
    this.recording = recording;
    this.errors = recording.localizers.map(() => ({position: [], yaw: []}));
    this.states = recording.localizers.map(() => []);
  }

  update(scan) {
    const {recording} = this;
    recording.localizers.forEach((localizer, k) => {
      const at = (track) => ({known: [track.known[scan]], x: [track.x[scan]], y: [track.y[scan]], yaw: [track.yaw[scan]]});
      const one = {scans: 1, torn: [recording.torn[scan]], truth: at(recording.truth)};
      const errors = errorsOf(one, at(localizer));
      this.errors[k].position[scan] = errors.position[0];
      this.errors[k].yaw[scan] = errors.yaw[0];
      [this.states[k][scan]] = statesOf({lost: [localizer.lost[scan]]}, errors, kRight.m, kRight.rad);
    });
  }
}

/** `send(command)`: to the run. */
export class LiveView {
  constructor(place, hello, send) {
    this.place = place;
    this.send = send;
    this.recording = new LiveRecording(hello);
    this.events = [];
    this.life = new AbortController();
    this.state = {time: 0, of: -1, scanAt: -1, follow: false, live: undefined, tool: 'teleport', holds: false,
      choices: {localizer: hello.localizers[0]}, show: new Set(['truth', 'estimates', 'particles', 'scan', 'people',
        'trails'])};
    this.build();
    this.recolor();
  }

  build() {
    const {recording, state} = this;
    const event = (body) => this.send({do: 'event', event: body});
    const canvas = element('canvas', {class: 'map', tabindex: 0, role: 'img',
      'aria-label': 'Map with the robot, its estimates, particles, scan and people'});
    this.mapView = new MapView(canvas, recording, this.events, state);
    this.mapView.hand = new MapHand(state, event);
    this.buttons = mapButtons((action, argument) => this.act(action, argument));
    this.states = new NewestStates(recording);
    const cards = element('div', {class: 'cards'});
    this.panel = new Panel(cards, {recording, errors: this.states.errors, states: this.states.states});
    this.log = element('ol', {class: 'log', 'aria-label': 'What happened'});
    this.note = element('p', {role: 'alert', class: 'note', hidden: true});
    this.drive = new LiveDrive(event);
    this.place.replaceChildren(this.transport(), this.note, element('div', {class: 'map-frame'}, canvas, this.buttons.row),
      cards, liveTools(state, recording.names, event), layerChoices(state, recording.names, () => this.changed()),
      mapLegend(), element('h3', {}, 'What happened'), this.log);
    this.listen();
  }

  transport() {
    const act = (command) => () => this.send(command);
    this.play = element('button', {type: 'button', class: 'play', click: () => this.toggle()}, 'Play');
    this.speed = element('select', {'aria-label': 'Speed', change: () => this.send({do: 'speed', value: Number(this.speed.value)})},
      ...kSpeeds.map((speed) => element('option', {value: speed, selected: speed === 1}, `${speed} ×`)));
    this.backTo = element('input', {type: 'number', min: 0, step: 0.1, value: 0, 'aria-label': 'Time to go back to [s]'});
    this.clock = element('output', {class: 'clock'});
    this.hands = element('button', {type: 'button', click: act({do: 'hands'})}, 'Take the hands');
    return element('div', {class: 'transport'}, this.play,
      element('button', {type: 'button', click: act({do: 'step'})}, 'Step a scan'), this.speed,
      this.backTo, element('button', {type: 'button', click: () => this.send({do: 'back', to_s: Number(this.backTo.value)})}, 'Go back'),
      element('button', {type: 'button', click: act({do: 'save'})}, 'Save as scenario'), this.hands, this.clock);
  }

  listen() {
    const ours = ({target}) => !['INPUT', 'SELECT', 'TEXTAREA'].includes(target.tagName);
    const {signal} = this.life;
    document.addEventListener('keydown', (event) => {
      if (!ours(event) || event.ctrlKey || event.metaKey || event.altKey) return;
      if (this.drive.key(event)) return;
      const acts = {' ': () => this.toggle(), '.': () => this.send({do: 'step'}), f: () => this.act('follow'),
        0: () => this.act('fit'), '+': () => this.act('zoom', 1.25), '-': () => this.act('zoom', 0.8)};
      if (!(event.key in acts) || (event.key === ' ' && event.target.tagName === 'BUTTON')) return;
      event.preventDefault();
      acts[event.key]();
    }, {signal});
    document.addEventListener('keyup', (event) => this.drive.key(event), {signal});
    window.addEventListener('blur', () => this.drive.release(), {signal});
  }

  /** Another view takes its place. */
  end() {
    this.life.abort();
    this.drive.end();
  }

  act(action, argument) {
    if (action === 'zoom') this.mapView.zoom(argument);
    if (action === 'fit') this.mapView.fit();
    if (action === 'follow') this.state.follow = !this.state.follow;
    this.changed();
  }

  toggle() {
    this.send({do: this.playing ? 'pause' : 'play'});
  }

  recolor() {
    this.colors = palette();
    this.mapView.setColors(this.colors);
    this.panel.recolor(this.colors);
    this.changed();
  }

  /** What the run says. */
  said(message) {
    const takes = {
      status: () => this.status(message),
      events: () => message.events.forEach((event) => this.happened(event)),
      done: () => this.done(message),
      error: () => this.noteText(message.text),
      scenario: () => this.download(message.yaml),
      hands: () => {
        this.state.holds = message.yours;
        this.hands.hidden = message.yours;
      },
    };
    takes[message.said]?.();
    this.changed();
  }

  status({playing, speed, now_s: now, times_real: real}) {
    this.playing = playing;
    this.play.textContent = playing ? 'Pause' : 'Play';
    if (document.activeElement !== this.speed) this.speed.value = String(speed);
    this.clock.textContent = `${clockText(now)} · ${playing ? `${real.toFixed(1)} × real time` : 'paused'}`;
  }

  happened(event) {
    const place = (pose) => (pose ? pose.slice(0, 2) : null);
    this.events.push({...event, from: place(event.from), to: place(event.to)});
    if (this.events.length > 500) this.events.splice(0, 100);
    const words = [event.kind, event.detail && `(${event.detail})`, event.localizer].filter(Boolean).join(' ');
    this.log.prepend(element('li', {}, `${clockText(event.time)}: ${words}`));
    if (this.log.childElementCount > 200) this.log.lastElementChild.remove();
  }

  /** An event of a hand took place; a command to drive is no event of the run. */
  done({event, at_s: time}) {
    this.noteText('');
    if (!event.drive) return;
    const {v = 0, w = 0} = event.drive;
    this.happened({time, kind: 'drive', detail: event.drive.v === undefined ? 'by the route again' : `${v} m/s, ${w} rad/s`});
  }

  noteText(text) {
    this.note.hidden = !text;
    this.note.textContent = text;
  }

  download(yaml) {
    const url = URL.createObjectURL(new Blob([yaml], {type: 'application/yaml'}));
    element('a', {href: url, download: `${this.recording.header.scenario}-live.yaml`}).click();
    URL.revokeObjectURL(url);
  }

  /** Takes a frame. */
  frame(frame) {
    if (frame.now < this.state.time - 1e-6) this.recording.cut(frame.now);
    this.recording.add(frame);
    this.state.time = frame.now;
    this.state.live = {truth: poseOf(frame.truth), estimates: frame.estimates.map(poseOf)};
    this.changed();
  }

  changed() {
    if (this.asked) return;
    this.asked = true;
    requestAnimationFrame(() => {
      this.asked = false;
      this.show();
    });
  }

  show() {
    this.mapView.draw();
    this.buttons.show(this.state.follow);
    const scan = this.recording.scans - 1;
    if (scan < 0) return;
    this.states.update(scan);
    this.panel.show(scan);
    const {dataset} = this.place;  // For who looks at the page from outside: tests.
    dataset.time = this.state.time.toFixed(4);
    dataset.truth = JSON.stringify(this.state.live.truth);
    dataset.view = JSON.stringify(this.mapView.view);
  }
}
