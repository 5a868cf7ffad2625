// A run's recording, as tools/outputs/sinks/recording_sink.hpp writes it.
import {Reader, column} from './varint.js';

const kFirstLine = 'castaway recording 1';
const kTruth = 1;  // Flags of a scan...
const kTorn = 2;
const kAnswer = 1;  // ...and of a localizer's answer to it.
const kLost = 2;

/** Header and sections of a recording's bytes (gunzipped). */
export function split(bytes) {
  const first = bytes.indexOf(10);
  const second = bytes.indexOf(10, first + 1);
  const text = new TextDecoder();
  if (first < 0 || second < 0 || text.decode(bytes.subarray(0, first)) !== kFirstLine) {
    throw new Error('the recording is of another version of castaway: make the report again');
  }
  const header = JSON.parse(text.decode(bytes.subarray(first + 1, second)));
  const sections = new Map();
  let at = second + 1;
  for (const {name, bytes: size} of header.sections) {
    sections.set(name, bytes.subarray(at, at + size));
    at += size;
  }
  return {header, sections};
}

/** The order that makes the scans go forward in time: several lidars deliver out of order. */
function orderOf(times) {
  const order = Array.from(times.keys());
  return order.sort((a, b) => times[a] - times[b] || a - b);
}

/** Where the blocks of a section begin, by detail. */
function offsets(sizes) {
  const at = new Float64Array(sizes.length + 1);
  for (let i = 0; i < sizes.length; ++i) at[i + 1] = at[i] + sizes[i];
  return at;
}

/** A run: columns over its scans by time, and the details of any of them. */
export class Recording {
  constructor(bytes) {
    const {header, sections} = split(bytes);
    this.header = header;
    this.sections = sections;
    this.changes = header.changes ?? [];  // Of the world, in order.
    this.scans = header.scans;
    this.names = header.localizers;
    const times = this.scans ? column(sections.get('time'), this.scans, header.steps.time) : [];
    this.order = orderOf(times);
    this.time = Float64Array.from(this.order, (i) => times[i]);
    const flags = this.ints('flags');
    this.truth = this.track('truth', flags.map((f) => f & kTruth));
    this.torn = flags.map((f) => (f & kTorn ? 1 : 0));
    this.localizers = this.names.map((name, k) => this.localizer(name, k));
    this.readDetails();
  }

  /** A column in order of time. */
  ints(name, step = 1) {
    if (!this.scans) return new Float64Array(0);
    const values = column(this.sections.get(name), this.scans, step);
    return Float64Array.from(this.order, (i) => values[i]);
  }

  /** Poses over the scans; `known`: whether there is one. */
  track(prefix, known) {
    const step = this.header.steps.pose;
    if (!this.sections.has(`${prefix}/x`)) {
      return {known, x: known, y: known, yaw: known};
    }
    const [x, y, yaw] = ['x', 'y', 'yaw'].map((part) => this.ints(`${prefix}/${part}`, step));
    const space = ['z', 'roll', 'pitch'].filter((part) => this.sections.has(`${prefix}/${part}`));
    return {known, x, y, yaw, ...Object.fromEntries(space.map((part) => [part, this.ints(`${prefix}/${part}`, step)]))};
  }

  localizer(name, k) {
    const {share, pose} = this.header.steps;
    const belief = (part, step) =>
      this.sections.has(`${k}/${part}`) ? this.ints(`${k}/${part}`, step) : new Float64Array(this.scans);
    const flags = this.ints(`${k}/flags`);
    return {
      name,
      ...this.track(String(k), flags.map((f) => f & kAnswer)),
      lost: flags.map((f) => (f & kLost ? 1 : 0)),
      quality: belief('quality', share),
      probability: belief('probability', share),
      sigma: belief('sigma', pose),
      sigmaYaw: belief('sigma_yaw', pose),
      populations: this.ints(`${k}/populations`),
      particles: this.ints(`${k}/particles`),
    };
  }

  /** Which detail a scan shows: its own, or the newest before it of the same lidar. */
  readDetails() {
    const bytes = this.sections.get('detail');
    const of = [];
    for (const reader = new Reader(bytes ?? new Uint8Array(0)); !reader.done;) {
      of.push((of.at(-1) ?? 0) + reader.nextSigned());
    }
    const place = new Map(this.order.map((scan, position) => [scan, position]));
    this.details = of.map((scan, detail) => ({scan: place.get(scan), detail}));
    this.details.sort((a, b) => a.scan - b.scan);
    const blocks = ['beams', 'people', ...this.names.map((_, k) => `${k}/points`)];
    this.blocks = new Map(blocks.filter(() => of.length > 0).map((name) => [
      name, offsets(column(this.sections.get(`${name}/sizes`), of.length))]));
  }

  /** Index of the newest scan at `time`, 0 before all. */
  scanAt(time) {
    let low = 0;
    let high = this.scans;
    while (low < high) {
      const middle = (low + high) >> 1;
      if (this.time[middle] <= time) low = middle + 1;
      else high = middle;
    }
    return Math.max(0, low - 1);
  }

  /** Position in `details` of the newest detail at a scan; -1 before all. */
  detailAt(scan) {
    let low = 0;
    let high = this.details.length;
    while (low < high) {
      const middle = (low + high) >> 1;
      if (this.details[middle].scan <= scan) low = middle + 1;
      else high = middle;
    }
    return low - 1;
  }

  /** The bytes of a block, to be read. */
  block(name, position) {
    const {detail} = this.details[position];
    const at = this.blocks.get(name);
    return new Reader(this.sections.get(name).subarray(at[detail], at[detail + 1]));
  }
}
