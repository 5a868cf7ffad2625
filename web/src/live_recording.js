// A recording that grows while its run goes on, with what the player asks of `Recording`. Old scans are forgotten.
import {fromBase64} from './bytes.js';
import {errorsOf, statesOf} from './measures.js';
import {Reader} from './varint.js';

const kMostScans = 18000;  // Half an hour at 10 Hz.
const kForgotten = 3000;  // At once.
const kMostDetails = 1800;  // Beams and particles of the last scans.

/** A pose within these of the truth is right, as the metrics have it. */
export const kLimits = {rightM: 0.5, rightRad: 0.35, rightDeg: (0.35 * 180) / Math.PI};

/** `space`: heights and what follows them, in a run on several floors. */
function emptyTrack(space = []) {
  return {known: [], x: [], y: [], yaw: [], ...Object.fromEntries(space.map((part) => [part, []]))};
}

/** `space`: of the pose, in the order of the track's. */
function addPose(track, pose, space = []) {
  track.known.push(pose ? 1 : 0);
  track.x.push(pose ? pose[0] : (track.x.at(-1) ?? 0));
  track.y.push(pose ? pose[1] : (track.y.at(-1) ?? 0));
  track.yaw.push(pose ? pose[2] : (track.yaw.at(-1) ?? 0));
  ['z', 'roll', 'pitch'].filter((part) => track[part]).forEach((part, i) => track[part].push(space[i] ?? 0));
}

/** Index of the last of ascending `values` that is at most `value`; -1 if there is none. */
function lastAtMost(values, value) {
  let low = 0;
  let high = values.length;
  while (low < high) {
    const middle = (low + high) >> 1;
    if (values[middle] <= value) low = middle + 1;
    else high = middle;
  }
  return low - 1;
}

/** Leaves those of a column out that are not kept, in place. */
function retain(column, keep) {
  let kept = 0;
  keep.forEach((stays, i) => {
    if (stays) column[kept++] = column[i];
  });
  column.length = kept;
}

export class LiveRecording {
  /** `hello`: what the run says at its beginning. */
  constructor(hello) {
    this.header = {...hello, lidars: []};
    this.names = hello.localizers;
    this.sections = new Map([['map', fromBase64(hello.cells)]]);
    (hello.levels?.cells ?? []).forEach((cells, level) => this.sections.set(`level/${level}`, fromBase64(cells)));
    this.number = [];  // Of each scan in the run.
    this.newest = -1;  // The highest of them.
    this.time = [];
    this.torn = [];
    this.truth = emptyTrack(hello.heights && ['z', 'roll', 'pitch']);
    this.localizers = this.names.map((name) => ({...emptyTrack(hello.heights && ['z']), name, lost: [], quality: [], probability: [],
      sigma: [], sigmaYaw: [], populations: [], particles: []}));
    this.errors = this.names.map(() => ({position: [], yaw: []}));
    this.states = this.names.map(() => []);
    this.details = [];
    this.changes = [];  // Of the world, in order.
  }

  get scans() {
    return this.time.length;
  }

  /** All columns over the scans. */
  columns() {
    const own = this.localizers.flatMap(({name, ...columns}) => Object.values(columns));
    const errors = this.errors.flatMap((columns) => Object.values(columns));
    return [this.number, this.time, this.torn, ...Object.values(this.truth), ...own, ...errors, ...this.states];
  }

  /**
   * Takes a frame (`readFrame`), or a history: scans from the number `first` on. Where they are others than those that are
   * there, the run went back. What is there after them never happened.
   */
  add({first, scans, lidars, blocks = []}) {
    if (lidars) this.header.lidars = lidars;
    const known = this.countKnown(first, scans);
    this.cutFrom(first + known);
    scans.slice(known).forEach((scan, i) => this.addScan(first + known + i, scan));
    if (blocks.length > 0 && scans.length > 0) this.addDetail(blocks);
    if (this.scans > kMostScans) this.forget(kForgotten);
  }

  /** How many of these scans are there already, without a gap. */
  countKnown(first, scans) {
    if (first > this.newest) return 0;
    const places = new Map(this.number.map((number, i) => [number, i]));
    const count = scans.findIndex((scan, i) => !this.isAt(places.get(first + i), scan));
    return count < 0 ? scans.length : count;
  }

  /** True if the scan at a place is this one. */
  isAt(place, [time, torn, truth, localizers]) {
    const at = (track, pose) => track.known[place] === (pose ? 1 : 0)
      && (!pose || [track.x, track.y, track.yaw].every((column, i) => column[place] === pose[i]));
    return this.time[place] === time && this.torn[place] === torn && at(this.truth, truth)
      && localizers.every(({answer}, k) => at(this.localizers[k], answer) && this.localizers[k].lost[place] === (answer?.[3] ?? 0));
  }

  /** Leaves out the scans with this number and later ones. */
  cutFrom(number) {
    if (number > this.newest) return;
    const keep = this.number.map((each) => each < number);
    let count = 0;
    const places = keep.map((stays) => (stays ? count++ : -1));
    for (const column of this.columns()) retain(column, keep);
    this.details = this.details.map((detail) => ({...detail, scan: places[detail.scan]})).filter(({scan}) => scan >= 0);
    this.newest = number - 1;
  }

  /** Beams and particles of the newest scan. */
  addDetail(blocks) {
    const scan = this.number.lastIndexOf(this.newest);
    const detail = {scan, blocks};
    const at = this.detailAt(scan);
    if (this.details[at]?.scan === scan) this.details[at] = detail;
    else this.details.splice(at + 1, 0, detail);
    if (this.details.length > kMostDetails) this.details.shift();
  }

  addScan(number, [time, torn, truth, localizers]) {
    this.number.push(number);
    this.newest = number;
    this.time.push(time);
    this.torn.push(torn);
    addPose(this.truth, truth, truth?.slice(3));
    localizers.forEach(({answer, populations, particles}, k) => {
      const localizer = this.localizers[k];
      addPose(localizer, answer, answer?.slice(8));
      localizer.lost.push(answer ? answer[3] : 0);
      localizer.quality.push(answer ? (answer[4] ?? -1) : 0);
      localizer.probability.push(answer ? (answer[5] ?? -1) : 0);
      localizer.sigma.push(answer ? answer[6] : 0);
      localizer.sigmaYaw.push(answer ? answer[7] : 0);
      localizer.populations.push(populations);
      localizer.particles.push(particles);
      this.judge(k);
    });
    this.sortNewest();
  }

  /** Several lidars deliver out of order: the newest scan is put where its time is. */
  sortNewest() {
    const last = this.scans - 1;
    if (last < 1 || this.time[last] >= this.time[last - 1]) return;
    const time = this.time[last];
    const place = this.time.findLastIndex((other, i) => i < last && other <= time) + 1;
    for (const column of this.columns()) column.splice(place, 0, column.pop());
    for (const detail of this.details) if (detail.scan >= place) ++detail.scan;
  }

  /** Error and state of a localizer at the newest scan. */
  judge(k) {
    const newest = ({known, x, y, yaw, z}) =>
      ({known: known.slice(-1), x: x.slice(-1), y: y.slice(-1), yaw: yaw.slice(-1), z: z?.slice(-1)});
    const localizer = this.localizers[k];
    const errors = errorsOf({scans: 1, torn: this.torn.slice(-1), truth: newest(this.truth)}, newest(localizer));
    this.errors[k].position.push(errors.position[0]);
    this.errors[k].yaw.push(errors.yaw[0]);
    this.states[k].push(...statesOf({lost: localizer.lost.slice(-1)}, errors, kLimits.rightM, kLimits.rightRad));
  }

  /** Leaves the oldest `count` scans out. */
  forget(count) {
    for (const column of this.columns()) column.splice(0, count);
    for (const detail of this.details) detail.scan -= count;
    this.details = this.details.filter(({scan}) => scan >= 0);
  }

  /**
   * Changes of the world (`change_entry`) of events (`LiveLog`): those of numbers from `first` on take the place of what was
   * there. True if anything is otherwise then.
   */
  takeChanges(first, events) {
    const kept = this.changes.filter((change) => change.number < first);
    const added = events.filter(({change}) => change).map(({change, number}) => ({...change, number}));
    const differs = added.length > 0 || kept.length < this.changes.length;
    this.changes = [...kept, ...added];
    return differs;
  }

  scanAt(time) {
    return Math.max(0, lastAtMost(this.time, time));
  }

  detailAt(scan) {
    return lastAtMost(this.details.map((detail) => detail.scan), scan);
  }

  block(name, position) {
    const {blocks} = this.details[position];
    const index = name === 'beams' ? 0 : name === 'people' ? 1 : 2 + Number.parseInt(name, 10);
    return new Reader(blocks[index]);
  }
}
