// What the 3-D view shows at a moment. A moment is what layers.js calls a scene, with `live.lift`: [height, roll, pitch].
import {beamPoints, beamsOf, peopleOf, populationsOf} from '../details.js';
import {kCorners, kTurns, pick, rgb, shade, stylesOf} from '../palette.js';
import {pieces, poseAt} from '../poses.js';
import {Changing3d} from './changing.js';
import {Walks, peopleBetween} from './gait.js';
import {addArc, arrows, Dots, softShadows, Trail} from './marks.js';
import {poseMatrix} from './meshes.js';
import {People3d} from './people.js';
import {Robots3d} from './robots.js';
import {World3d} from './world.js';

const kTrail = 12;  // [s]
const kKidnapShown = 3;  // [s]
const kBeforeCamera = 1.3;  // [m]
const kTruth = [0.07, 0.08, 0.09];
const kHit = [0.85, 0.1, 0.15];  // As in the pictures.

const share = (color) => rgb(color).map((value) => value / 255);

export class Content3d {
  constructor(json, names, scene, light) {
    this.names = names;
    this.styles = stylesOf(names);
    this.world = new World3d(json, light);
    this.robots = new Robots3d(json, light, names, {corners: this.styles.map((style) => pick(kCorners, style)), turns: this.styles.map((style) => pick(kTurns, style))});
    this.people = new People3d(json.person, light);
    this.changing = new Changing3d(json.changing, light);
    this.walks = new Walks();
    this.hits = new Dots(8000, 3, {order: 5});
    this.particles = new Dots(12000, 3, {order: 3, opacity: 0.85});
    this.arc = new Dots(600, 5, {order: 9, depthTest: false});
    this.shadows = softShadows(600);
    this.arrows = arrows(300);
    this.trails = [new Trail(0.3, 2), ...names.map(() => new Trail(0.75, 2.5))];
    this.scene = scene;
    for (const part of this.parts()) part.addTo(scene);
    scene.add(...this.objects());
  }

  parts() {
    return [this.world, this.robots, this.people, this.changing];
  }

  objects() {
    return [this.hits, this.particles, this.arc, this.shadows, this.arrows, ...this.trails].map(({object}) => object);
  }

  remove() {
    for (const part of this.parts()) part.removeFrom(this.scene);
    this.scene.remove(...this.objects());
    for (const object of this.objects()) object.geometry.dispose();
  }

  recolor(colors) {
    const own = this.styles.map((style) => pick(colors.localizers, style));
    this.colors = {localizers: own.map(share), populations: own.map((color) => [0, 1, 2].map((id) => share(shade(color, id)))),
      mark: share(colors.mark)};
    this.robots.recolor(this.colors.localizers, kTruth);
  }

  /** `eye`: where the camera is [m]; `ratio`: of the canvas's pixels to the page's. */
  show(moment, eye, ratio) {
    this.changing.show(moment.recording.changes, moment.time);
    this.showRobots(moment, eye);
    this.showPeople(moment, eye);
    this.showHits(moment);
    this.showParticles(moment);
    this.showTrails(moment);
    this.showKidnaps(moment);
    this.hits.done(3.4 * ratio);
    this.particles.done(2.6 * ratio);
    this.arc.done(5 * ratio);
    this.arrows.done();
    this.shadows.done();
  }

  showRobots(moment, eye) {
    const {recording, scan, time, show, live} = moment;
    const radius = recording.header.robot_radius_m;
    this.shadows.clear();
    const truth = show.has('truth') ? (live?.truth ?? poseAt(recording.truth, recording.time, scan, time)) : null;
    const lift = live?.lift ?? truth?.lift;
    this.robots.truth.show(truth, lift, truth && Robots3d.ringSize(truth, eye, radius));
    if (truth) this.shadows.add(truth, 0.006 + (truth.z ?? 0), 1.5 * radius);
    this.labels = [];
    this.robots.ghosts.forEach((ghost, k) => {
      const localizer = recording.localizers[k];
      const shown = show.has('estimates') && (moment.of < 0 || moment.of === k) && recording.scans > 0;
      const pose = shown ? (live?.estimates[k] ?? poseAt(localizer, recording.time, scan, time)) : null;
      const lost = Boolean(localizer.lost[scan]);
      const above = (pose?.z ?? 0) - (truth?.z ?? 0);
      const near = pose && truth && Math.hypot(pose.x - truth.x, pose.y - truth.y, above) < 1;
      ghost.show(pose, {lift: ghostLift(pose, near ? lift : undefined), lost, near, sigma: localizer.sigma[scan] ?? 0,
        size: pose && Robots3d.ringSize(pose, eye, radius) * (1 + 0.14 * (k + 1))});
      if (pose) this.labels.push({k, lost, at: [pose.x, pose.y, 0.55 + (pose.z ?? 0)]});
    });
  }

  /** Who stands right before the camera is not in its way. */
  showPeople(moment, eye) {
    const {recording, detail, time, show} = moment;
    const all = show.has('people') && detail >= 0 ? this.walks.add(peopleNow(recording, detail, time)) : [];
    const people = all.filter(({x, y}) => eye[2] > 3 || Math.hypot(x - eye[0], y - eye[1]) > kBeforeCamera);
    this.people.show(people, eye);
    for (const person of people) this.shadows.add(person, 0.005, 0.42);
  }

  /** The newest scan of every lidar, from where the robot was, or was believed to be. */
  showHits({recording, detail, show, scanAt, live}) {
    this.hits.clear();
    if (!show.has('scan')) return;
    const track = scanAt < 0 ? recording.truth : recording.localizers[scanAt];
    const wanted = new Set(recording.header.lidars.map((lidar) => lidar.name));
    for (let at = detail; at >= 0 && at > detail - 12 && wanted.size; --at) {
      const {lidar: index, ranges} = beamsOf(recording, at);
      const lidar = recording.header.lidars[index];
      const pose = poseAt(track, recording.time, recording.details[at].scan, 0);
      if (!wanted.delete(lidar.name) || !pose) continue;
      const T = poseMatrix(pose, pose.lift ?? (pose.z === undefined ? live?.lift : [pose.z, 0, 0]));
      const points = beamPoints(lidar, ranges);
      for (let i = 0; i < points.length; i += 3) {
        const [x, y, z] = [points[i], points[i + 1], points[i + 2]];
        this.hits.add(T[0] * x + T[4] * y + T[8] * z + T[12], T[1] * x + T[5] * y + T[9] * z + T[13],
          T[2] * x + T[6] * y + T[10] * z + T[14], kHit);
      }
    }
  }

  /** Particles, and an arrow at the mean of each population that is not the output. */
  showParticles(moment) {
    const {recording, detail, show} = moment;
    this.particles.clear();
    this.arrows.clear();
    if (!show.has('particles') || detail < 0) return;
    const size = 2.2 * recording.header.robot_radius_m;
    recording.localizers.forEach((_, k) => {
      if (moment.of >= 0 && moment.of !== k) return;
      for (const population of populationsOf(recording, k, detail)) {
        const color = pick(this.colors.populations[k], population.id);
        const {points, z = 0} = population;
        for (let i = 0; i < points.length; i += 2) this.particles.add(points[i], points[i + 1], 0.02 + z, color);
        if (!population.selected) this.arrows.add(population, 0.03 + z, size, color);
      }
    });
  }

  showTrails({recording, time, scan, show, of}) {
    const tracks = [recording.truth, ...recording.localizers];
    tracks.forEach((track, i) => {
      const shown = recording.scans > 0 && show.has('trails') && (i === 0 || of < 0 || of === i - 1);
      const heights = [];
      const lines = shown ? pieces(track, recording.scanAt(time - kTrail), scan, () => true, heights) : [];
      const color = i === 0 ? kTruth : this.colors.localizers[i - 1];
      this.trails[i].show(lines, i === 0 ? 0.09 : 0.035, 0.01 + 0.002 * i, color, heights);
    });
  }

  showKidnaps({events, time}) {
    this.arc.clear();
    for (const {kind, from, to, time: at} of events) {
      if (kind === 'kidnap' && from && to && time >= at && time <= at + kKidnapShown) addArc(this.arc, from, to, this.colors.mark);
    }
  }
}

/** [height, roll, pitch] of a ghost: tilted as the robot is where `near` says how; nothing on level floor. */
function ghostLift(pose, near) {
  if (pose?.z === undefined) return near;
  return [pose.z, ...(near ?? [0, 0, 0]).slice(1)];
}

/** The people of a detail at `time`, between it and the next one, or carried on from the one before. */
function peopleNow(recording, detail, time) {
  const timeOf = (at) => recording.time[recording.details[at].scan];
  const next = detail + 1 < recording.details.length ? detail + 1 : detail;
  const before = Math.max(0, next - 1);
  return peopleBetween(peopleOf(recording, before), timeOf(before), peopleOf(recording, next), timeOf(next), time);
}
