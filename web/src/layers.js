// What the map shows, each layer by a function of (context, scene). A scene is:
// {recording, view, colors, time, scan, detail, show: set of layers, of: localizer shown or -1,
//  scanAt: -1 for the truth or a localizer, map and mapCanvas of the floor that is seen, onLevel(z): true on it, events,
//  errors: of each localizer over the scans, errorOf: localizer whose errors colour the path or -1,
//  live: {truth, estimates} between scans, or undefined}
import {beamEnds, beamsOf, peopleOf, populationsOf} from './details.js';
import {kDashes, outline, pick, shade, styleOf} from './palette.js';
import {pieces, poseAt} from './poses.js';
import {toScreen} from './view.js';
import {worldAt} from './world_changes.js';

const kTrail = 12;  // [s]
const kKidnapShown = 3;  // [s]
const kElsewhere = 0.3;  // Opacity of robots on other floors.

function shown(scene) {
  return scene.recording.localizers.map((localizer, k) => ({localizer, k}))
    .filter(({k}) => scene.of < 0 || scene.of === k);
}

function stroke(context, view, parts) {
  for (const part of parts) {
    context.beginPath();
    for (let i = 0; i < part.length; i += 2) context.lineTo(...toScreen(view, part[i], part[i + 1]));
    context.stroke();
  }
}

/** The way of the last seconds, or all of it. */
export function drawPaths(context, scene, whole) {
  const {recording, view, colors, time, scan} = scene;
  const from = whole ? 0 : recording.scanAt(time - kTrail);
  const to = whole ? recording.scans - 1 : scan;
  const tracks = [{track: recording.truth, color: colors.ink, dash: [], width: 5}];
  for (const {localizer, k} of shown(scene)) {
    tracks.push({
      track: localizer, color: pick(colors.localizers, styleOf(recording.names, k)),
      dash: pick(kDashes, styleOf(recording.names, k)), width: 2,
    });
  }
  context.save();
  context.lineJoin = 'round';
  for (const {track, color, dash, width} of tracks) {
    context.globalAlpha = track === recording.truth ? 0.22 : 0.8;
    context.strokeStyle = color;
    context.lineWidth = whole ? width * 0.6 : width;
    context.setLineDash(dash);
    stroke(context, view, pieces(track, from, to, scene.onLevel));
  }
  context.restore();
}

/** A particle: a square for localizers of an even style, a cross for the others. */
function dot(context, style, px, py, size) {
  if (style % 2 === 0) {
    context.fillRect(px - size / 2, py - size / 2, size, size);
  } else {
    context.fillRect(px - size, py - 0.6, 2 * size, 1.2);
    context.fillRect(px - 0.6, py - size, 1.2, 2 * size);
  }
}

export function drawParticles(context, scene) {
  const {recording, view, colors, detail} = scene;
  if (detail < 0) return;
  for (const {k} of shown(scene)) {
    const style = styleOf(recording.names, k);
    for (const population of populationsOf(recording, k, detail).filter(({z}) => scene.onLevel(z))) {
      const size = population.selected ? 3 : 2.4;
      context.fillStyle = shade(pick(colors.localizers, style), population.id);
      context.globalAlpha = population.selected ? 0.85 : 0.7;
      const {points} = population;
      for (let i = 0; i < points.length; i += 2) {
        dot(context, style, ...toScreen(view, points[i], points[i + 1]), size);
      }
    }
  }
  context.globalAlpha = 1;
}

/** The newest scan of every lidar, from where the robot was, or was believed to be. */
export function drawScan(context, scene) {
  const {recording, view, colors, detail} = scene;
  const track = scene.scanAt < 0 ? recording.truth : recording.localizers[scene.scanAt];
  const wanted = new Set(recording.header.lidars.map((lidar) => lidar.name));
  context.fillStyle = colors.scan;
  for (let at = detail; at >= 0 && at > detail - 12 && wanted.size; --at) {
    const {lidar: index, ranges} = beamsOf(recording, at);
    const lidar = recording.header.lidars[index];
    const pose = poseAt(track, recording.time, recording.details[at].scan, 0);
    if (!wanted.delete(lidar.name) || !pose || !scene.onLevel(pose.z)) continue;
    const [cos, sin] = [Math.cos(pose.yaw), Math.sin(pose.yaw)];
    const ends = beamEnds(lidar, ranges);
    for (let i = 0; i < ends.length; i += 2) {
      const [px, py] = toScreen(view, pose.x + cos * ends[i] - sin * ends[i + 1],
        pose.y + sin * ends[i] + cos * ends[i + 1]);
      context.fillRect(px - 1.5, py - 1.5, 3, 3);
    }
  }
}

/** Doors, and what was put into the world. */
export function drawWorld(context, {recording, view, colors, time}) {
  context.save();
  context.lineWidth = 1.5;
  for (const {outline: corners, door} of worldAt(recording.header, recording.changes, time).values()) {
    context.beginPath();
    for (const [x, y] of corners) context.lineTo(...toScreen(view, x, y));
    context.closePath();
    context.fillStyle = context.strokeStyle = door ? colors.warn : colors.mark;
    context.globalAlpha = 0.35;
    context.fill();
    context.globalAlpha = 1;
    context.stroke();
  }
  context.restore();
}

export function drawPeople(context, {recording, view, colors, detail}) {
  if (detail < 0) return;
  for (const person of peopleOf(recording, detail)) {
    const [px, py] = toScreen(view, person.x, person.y);
    context.save();
    context.translate(px, py);
    context.rotate(-person.yaw);
    context.scale(Math.max(view.scale, 14), Math.max(view.scale, 14));
    context.fillStyle = colors.person;
    context.beginPath();
    context.ellipse(0, 0, 0.15, 0.24, 0, 0, 2 * Math.PI);
    context.ellipse(0.14, 0, 0.06, 0.05, 0, 0, 2 * Math.PI);
    context.fill();
    context.restore();
  }
}

/** A robot: an outline and where it faces. */
function drawRobot(context, {recording, view, onLevel}, pose, k, style) {
  const [px, py] = toScreen(view, pose.x, pose.y);
  const radius = Math.max(recording.header.robot_radius_m * view.scale, 7) * (k < 0 ? 1.25 : 1);
  context.save();
  context.globalAlpha = onLevel(pose.z) ? 1 : kElsewhere;
  context.translate(px, py);
  context.rotate(-pose.yaw);
  outline(context, k < 0 ? 0 : styleOf(recording.names, k), radius);
  context.lineWidth = style.width;
  context.strokeStyle = style.color;
  context.setLineDash(style.dash ?? []);
  context.stroke();
  context.setLineDash([]);
  context.beginPath();
  context.moveTo(k < 0 ? 0.3 * radius : 0, 0);
  context.lineTo(1.7 * radius, 0);
  context.stroke();
  context.restore();
}

export function drawTruth(context, scene) {
  const {recording, colors, scan, time} = scene;
  const pose = scene.live?.truth ?? poseAt(recording.truth, recording.time, scan, time);
  if (pose) drawRobot(context, scene, pose, -1, {color: colors.ink, width: 4});
}

export function drawEstimates(context, scene) {
  const {recording, view, colors, scan, time} = scene;
  for (const {localizer, k} of shown(scene)) {
    const pose = scene.live?.estimates[k] ?? poseAt(localizer, recording.time, scan, time);
    if (!pose) continue;
    const color = pick(colors.localizers, styleOf(recording.names, k));
    const [px, py] = toScreen(view, pose.x, pose.y);
    context.fillStyle = color;
    context.globalAlpha = scene.onLevel(pose.z) ? 0.15 : 0;
    context.beginPath();
    context.arc(px, py, Math.min(2 * localizer.sigma[scan] * view.scale, 2000), 0, 2 * Math.PI);
    context.fill();
    context.globalAlpha = 1;
    drawRobot(context, scene, pose, k, {color, width: 2.5, dash: localizer.lost[scan] ? [3, 3] : []});
    if (!localizer.lost[scan]) continue;
    context.font = 'bold 15px system-ui, sans-serif';
    context.fillText('?', px + 12, py - 10);
  }
}

/** From where to where it was kidnapped, for some seconds. */
export function drawKidnaps(context, {view, colors, time, events}) {
  context.save();
  context.strokeStyle = colors.mark;
  context.lineWidth = 2;
  context.setLineDash([6, 5]);
  for (const event of events) {
    if (event.kind !== 'kidnap' || !event.from || !event.to) continue;
    if (time < event.time || time > event.time + kKidnapShown) continue;
    stroke(context, view, [[...event.from, ...event.to]]);
  }
  context.restore();
}
