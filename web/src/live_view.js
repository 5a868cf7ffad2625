// The page of a live run: map, states, time, tools, a curve, and what happened.
import {layerChoices, mapButtons} from './controls.js';
import {clockText, element, reveal} from './dom.js';
import {ownsKey} from './keys.js';
import {FaultBanner} from './live_banner.js';
import {LiveCurve} from './live_curve.js';
import {LiveDrive} from './live_drive.js';
import {MapHand} from './live_hands.js';
import {fileTools} from './live_files.js';
import {LiveLog} from './live_log.js';
import {LiveRecording} from './live_recording.js';
import {StartButton} from './live_start.js';
import {liveTools} from './live_tools.js';
import {floorOf} from './levels.js';
import {mapLegend} from './legend.js';
import {MapView} from './map_view.js';
import {marksOf} from './marks.js';
import {palette} from './palette.js';
import {Panel} from './panel.js';
import {save} from './saving.js';
import {Timeline} from './timeline.js';
import {Views} from './view3d/views.js';
import {worldAt} from './world_changes.js';

const kSpeeds = [0.1, 0.25, 0.5, 1, 2, 5, 10, 20, 50, 100];
const kTimelinePeriod = 250;  // [ms] Timeline and curve are drawn less often than the map.

const poseOf = (pose) => (pose ? {x: pose[0], y: pose[1], yaw: pose[2]} : null);

/** `send(command)`: to the run. */
export class LiveView {
  constructor(place, hello, send) {
    this.place = place;
    place.view = this;  // For who looks at the page from outside: tests.
    this.send = send;
    this.recording = new LiveRecording(hello);
    this.log = new LiveLog();
    this.life = new AbortController();
    this.drawnTime = -Infinity;
    this.state = {time: 0, of: -1, scanAt: -1, level: -1, follow: false, live: undefined, tool: 'teleport', holds: false,
      choices: {localizer: hello.localizers[0], people: {count: 1, walk: false}}, things: () => this.things(), seenLevel: () => this.seenLevel(), show: new Set(['truth', 'estimates', 'particles', 'scan', 'people',
        'trails'])};
    this.now = 0;
    this.past = null;  // The time that is looked at; null: now.
    this.colors = palette();
    this.build();
    this.recolor();
  }

  build() {
    const {recording, state} = this;
    const event = (body) => this.send({do: 'event', event: body});
    const colors = () => this.colors;
    const look = (time) => this.look(time);
    const canvas = element('canvas', {class: 'map', tabindex: 0, role: 'img',
      'aria-label': 'Map with the robot, its estimates, particles, scan and people'});
    this.mapView = new MapView(canvas, recording, this.log.events, state);
    this.mapView.hand = new MapHand(state, event);
    this.mapView.onMoved = () => this.buttons.show(state.follow);
    this.views = new Views(this.mapView, recording, this.log.events, state, () => this.changed());
    this.buttons = mapButtons((action, argument) => this.act(action, argument), this.views.above);
    const cards = element('div', {class: 'cards'});
    this.panel = new Panel(cards, recordingRun(recording));
    this.note = element('p', {role: 'alert', class: 'note', hidden: true});
    this.drive = new LiveDrive(recording.header.recorded ? () => {} : event);
    const time = element('div', {class: 'timeline'});
    const curve = element('div', {class: 'curve'});
    this.tools = liveTools(state, recording.names, event, recording.header.recorded);
    this.tools.showThings(this.things());
    const transport = this.transport();
    this.faults = new FaultBanner();
    this.start = new StartButton(() => this.send({do: 'play'}), this.play);
    this.place.replaceChildren(transport, element('div', {class: 'notes'}, this.note, notesOf(recording.header)), this.tools.panel,
      element('div', {class: 'map-frame'}, canvas, ...this.views.parts, this.buttons.row, this.faults.line, this.start.button), cards,
      time, curve, element('div', {class: 'log-frame'}, element('h2', {}, 'What happened'), this.log.list),
      element('div', {class: 'below'}, layerChoices(state, recording.names, () => this.changed(), recording.header.levels?.z_m), mapLegend()));
    this.timeline = new Timeline(time, recordingRun(recording), [], colors, look);
    this.curve = new LiveCurve(curve, recording, colors, look);
    this.listen();
  }

  transport() {
    const button = (text, act, more = {}) => element('button', {type: 'button', click: act, ...more}, text);
    const order = (command) => () => this.send(command);
    this.play = button('Play', () => this.toggle(), {class: 'play'});
    this.speed = element('select', {'aria-label': 'Speed', change: () => this.send({do: 'speed', value: Number(this.speed.value)})},
      ...kSpeeds.map((speed) => element('option', {value: speed, selected: speed === 1}, `${speed} ×`)));
    this.clock = element('output', {class: 'clock', 'aria-live': 'off'});
    this.hands = button('Take the hands', order({do: 'hands'}));
    this.again = button('Go on from here', () => this.goOn());
    this.toNow = button('Back to now', () => this.look(null));
    this.hands.hidden = this.again.hidden = this.toNow.hidden = true;
    const files = fileTools(this.place, this.life.signal, (chosen) => this.send({do: 'load', ...chosen}),
      (...parts) => this.noteParts(parts));
    return element('div', {class: 'transport'}, this.play, button('Step a scan', order({do: 'step'})), this.speed,
      button('Save as scenario', order({do: 'save'})),
      button('Report', order({do: 'report'}), {title: 'Plays the run until now again and makes its report'}), ...files,
      this.hands, this.again, this.toNow, this.clock);
  }

  listen() {
    const {signal} = this.life;
    document.addEventListener('keydown', (event) => this.key(event), {signal});
    document.addEventListener('keyup', (event) => this.drive.key(event), {signal});
    window.addEventListener('blur', () => this.drive.release(), {signal});
  }

  key(event) {
    if (ownsKey(event.target, event.key) || event.ctrlKey || event.metaKey || event.altKey) return;
    if (this.drive.key(event)) return;
    const acts = {' ': () => this.toggle(), '.': () => this.send({do: 'step'}), f: () => this.act('follow'),
      0: () => this.act('fit'), 3: () => this.act('toggle3d'), t: () => this.act('top'), '+': () => this.act('zoom', 1.25), '-': () => this.act('zoom', 0.8),
      ArrowLeft: () => this.stepPast(-1), ArrowRight: () => this.stepPast(1), Escape: () => this.look(null)};
    if (!(event.key in acts)) return;
    event.preventDefault();
    acts[event.key]();
  }

  /** Another view takes its place. */
  end() {
    this.life.abort();
    this.drive.end();
  }

  act(action, argument) {
    if (action === 'zoom') this.views.zoom(argument);
    if (action === 'fit') this.views.fit();
    if (action === 'top') this.views.top();
    if (action === 'toggle3d') this.views.toggle();
    if (action === 'follow') this.state.follow = !this.state.follow;
    this.changed();
  }

  toggle() {
    this.send({do: this.playing ? 'pause' : 'play'});
  }

  /** Looks at a moment of the past while the run goes on; null: at now. */
  look(time) {
    const newest = this.recording.time.at(-1) ?? 0;
    this.past = time === null || time >= newest ? null : Math.max(time, this.recording.time[0]);
    for (const button of [this.again, this.toNow]) reveal(button, this.past !== null, this.play);
    this.drawnTime = -Infinity;
    this.changed();
  }

  stepPast(count) {
    const {time} = this.recording;
    const to = this.recording.scanAt(this.past ?? this.now) + count;
    this.look(to >= time.length - 1 ? null : time[Math.max(0, to)]);
  }

  /** The run goes back to the moment that is looked at. */
  goOn() {
    this.send({do: 'back', to_s: this.past});
    this.look(null);
  }

  recolor() {
    this.colors = palette();
    this.views.setColors(this.colors);
    this.panel.recolor(this.colors);
    this.timeline.draw();
    this.curve.recolor();
    this.changed();
  }

  /** What the run says. */
  said(message) {
    const takes = {
      history: () => this.recording.add(message),
      scene: () => this.views.setScene(message.scene),
      status: () => this.status(message),
      events: () => this.happened(message),
      done: () => this.noteText(''),
      error: () => this.noteText(message.text),
      scenario: () => this.download(message.yaml),
      report: () => this.offerReport(message),
      hands: () => {
        this.state.holds = message.yours;
        reveal(this.hands, !message.yours, this.play);
      },
    };
    takes[message.said]?.();
    this.changed();
  }

  status({playing, speed, now_s: now, times_real: real}) {
    this.playing = playing;
    this.start.show(playing, this.recording.scans > 1);
    this.play.textContent = playing ? 'Pause' : 'Play';
    if (document.activeElement !== this.speed) this.speed.value = String(speed);
    this.clock.textContent = `${clockText(now)} · ${playing ? `${real.toFixed(1)} × real time` : 'paused'}`;
  }

  happened({first, events}) {
    if (this.recording.takeChanges(first, this.log.take(first, events))) this.tools.showThings(this.things());
  }

  /** The floor that is seen, where there are several. */
  seenLevel() {
    const {recording, state} = this;
    if (!(recording.header.levels?.z_m.length > 1)) return undefined;
    return floorOf(state, recording, Math.max(0, recording.scans - 1)).level;
  }

  /** What stands in the world now, besides the map. */
  things() {
    return worldAt(this.recording.header, this.recording.changes, Infinity);
  }

  noteText(text) {
    this.note.hidden = !text;
    this.note.textContent = text;
  }

  noteParts(parts) {
    this.note.hidden = false;
    this.note.replaceChildren(...parts);
  }

  offerReport({number, folder}) {
    const link = element('a', {href: `/report/${number}${window.location.search}`, target: '_blank'},
      `Report ${number}`);
    this.noteParts([link, ` of the run until then. Its folder: ${folder}`]);
  }

  download(yaml) {
    save(`${this.recording.header.scenario}-live.yaml`, yaml, 'application/yaml');
  }

  /** Robot and estimates now; on several floors with heights, those of the estimates from their newest scan. */
  posesOf({truth, estimates, lift}) {
    const poses = {truth: poseOf(truth), estimates: estimates.map(poseOf), lift};
    if (!this.recording.header.heights) return poses;
    poses.lift ??= [0, 0, 0];
    if (poses.truth) poses.truth.z = poses.lift[0];
    poses.estimates.forEach((pose, k) => {
      if (pose) pose.z = this.recording.localizers[k].z.at(-1) ?? 0;
    });
    return poses;
  }

  /** Takes a frame. */
  frame(frame) {
    this.recording.add(frame);
    this.now = frame.now;
    this.poses = this.posesOf(frame);
    if (this.past !== null && this.past >= (this.recording.time.at(-1) ?? 0)) this.look(null);  // It never happened.
    this.changed();
  }

  changed() {
    if (this.asked) return;
    this.asked = true;
    requestAnimationFrame((wall) => {
      this.asked = false;
      this.show(wall);
    });
  }

  show(wall) {
    const {state, recording} = this;
    state.time = this.past ?? this.now;
    state.live = this.past === null ? this.poses : undefined;
    this.views.draw();
    this.buttons.show(state.follow);
    this.faults.show(this.log.events, state.time);
    if (recording.scans === 0) return;
    const scan = recording.scanAt(state.time);
    this.panel.show(scan);
    this.showTime(wall, scan);
    const {dataset} = this.place;  // For who looks at the page from outside: tests.
    dataset.time = state.time.toFixed(4);
    dataset.truth = JSON.stringify(this.poses?.truth ?? null);
    dataset.view = JSON.stringify(this.mapView.view);
  }

  showTime(wall, scan) {
    if (wall - this.drawnTime < kTimelinePeriod) {
      this.later ??= setTimeout(() => this.changed(), kTimelinePeriod);
      return;
    }
    clearTimeout(this.later);
    this.later = undefined;
    this.drawnTime = wall;
    this.timeline.grown(marksOf(this.log.events));
    this.timeline.show(this.state.time, scan);
    this.curve.update();
  }
}

/** What is to be known of the run, a line; nothing where there is nothing. */
function notesOf({notes = []}) {
  return element('p', {class: 'run-notes soft', hidden: notes.length === 0}, notes.length ? `Note: ${notes.join('. ')}.` : '');
}

/** What panel and timeline read of a recording. */
function recordingRun(recording) {
  return {recording, errors: recording.errors, states: recording.states};
}
