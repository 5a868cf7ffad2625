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

export class LiveRecording {
  /** `hello`: what the run says at its beginning. */
  constructor(hello) {
    this.header = {...hello, lidars: []};
    this.names = hello.localizers;
    this.sections = new Map([['map', fromBase64(hello.cells)]]);
    (hello.levels?.cells ?? []).forEach((cells, level) => this.sections.set(`level/${level}`, fromBase64(cells)));
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
    return [this.time, this.torn, ...Object.values(this.truth), ...own, ...errors, ...this.states];
  }

  /** Takes a frame (`readFrame`). */
  add({scans, lidars, blocks}) {
    if (lidars) this.header.lidars = lidars;
    for (const scan of scans) this.addScan(scan);
    if (blocks.length > 0 && scans.length > 0) {
      this.details.push({scan: this.scans - 1, blocks});
      if (this.details.length > kMostDetails) this.details.shift();
    }
    if (this.scans > kMostScans) this.forget(kForgotten);
  }

  addScan([time, torn, truth, localizers]) {
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

  /** Leaves out what comes after `time`: the run went back. */
  cut(time) {
    const kept = lastAtMost(this.time, time + 1e-6) + 1;
    for (const column of this.columns()) column.length = kept;
    this.details = this.details.filter(({scan}) => scan < kept);
    this.changes = this.changes.filter((change) => change.time <= time + 1e-6);
  }

  /** Takes a change of the world (`change_entry`). */
  addChange(change) {
    this.changes.push(change);
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
