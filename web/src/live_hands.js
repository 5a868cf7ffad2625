// What a pointer on the map does: the tool that is chosen, as the event that it asks for.
import {toScreen} from './view.js';
import {isOpen, nearest} from './world_changes.js';

const kNear = 26;  // [px] From the robot, to grab it.
const kTurn = 0.25;  // [m] A shorter drag has no direction of its own.

/** The pose at `from` that looks at `to`; `yaw` where they are too near to each other. */
export function facing(from, to, yaw) {
  const [dx, dy] = [to[0] - from[0], to[1] - from[1]];
  return [from[0], from[1], Math.hypot(dx, dy) < kTurn ? yaw : Math.atan2(dy, dx)];
}

const kReach = 0.35;  // [m] From a door or a box, to touch it.

const degrees = (yaw) => Number(((yaw * 180) / Math.PI).toFixed(1));
const rounded = (pose) => pose.map((value) => Number(value.toFixed(3)));
const placed = (pose, level) => ({pose: rounded(pose), ...(level !== undefined && {level})});

/**
 * Tools by name. `event(pose, choices)`: what they ask for at a pose, as an event of a scenario. `choices.level`: the floor
 * that is seen, where there are several.
 */
export const kTools = {
  teleport: {text: 'Teleport', drags: true, help: 'Drag the robot; a kidnap that takes no time.',
    event: (pose, {level}) => ({kidnap: {kind: 'teleport', ...placed(pose, level)}})},
  carry: {text: 'Carry', drags: true, help: 'Drag the robot; it is lifted, carried and put down.',
    event: (pose, {level}) => ({kidnap: {kind: 'carry', ...placed(pose, level)}})},
  box: {text: 'Box', drags: false, help: 'Press where it goes, and drag to turn it. It is not on the map.',
    event: ([x, y, yaw]) => ({box: {at: rounded([x, y]), yaw_deg: degrees(yaw), size: [0.6, 0.4, 0.6]}})},
  person: {text: 'People', drags: false, help: 'Press where they come, and drag to where they look.',
    event: ([x, y, yaw], {people}) => ({people: {at: rounded([x, y]), yaw_deg: degrees(yaw), ...people}})},
  thing: {text: 'Door, remove', touches: true, help: 'Press a door to open or close it, or a box to take it away.'},
  initial: {text: 'Initial pose', drags: false, help: 'Press where the robot is, and drag to where it looks.',
    event: (pose, choices) => ({localizer: {name: choices.localizer, do: 'initialize', pose: rounded(pose)}})},
};

/** What a touch does to something in the world: a door is turned, a box is taken away. */
export function touchEvent(name, thing) {
  if (!thing.door) return {remove: {name}};
  return {door: {name, open_deg: isOpen(thing) ? 0 : 90}};
}

/** The hand on the map. `state`: {tool, choices, live}; `send(event)`. */
export class MapHand {
  constructor(state, send) {
    this.state = state;
    this.send = send;
    this.ghost = null;
  }

  tool() {
    return kTools[this.state.tool] ?? null;
  }

  /** Takes hold of the robot, or of a place. `view` is the map's. */
  grab(point, view) {
    const tool = this.tool();
    const robot = this.state.live?.truth;
    if (!tool || !robot || !this.state.holds) return null;
    if (tool.touches) return this.touch(point);
    if (tool.drags) {
      const [px, py] = toScreen(view, ...point);
      const [rx, ry] = toScreen(view, robot.x, robot.y);
      if (Math.hypot(px - rx, py - ry) > kNear) return null;
      this.ghost = [robot.x, robot.y, robot.yaw];
      return this.grip(tool, (to) => [to[0], to[1], robot.yaw]);
    }
    this.ghost = [point[0], point[1], robot.yaw];
    return this.grip(tool, (to) => facing(point, to, robot.yaw));
  }

  touch(point) {
    const things = this.state.things();
    const name = nearest(things, point, kReach);
    if (!name) return null;
    return {move: () => {}, drop: () => this.send(touchEvent(name, things.get(name)))};
  }

  grip(tool, poseAt) {
    return {
      move: (to) => {
        this.ghost = poseAt(to);
      },
      drop: (to) => {
        this.ghost = null;
        this.send(tool.event(poseAt(to), {...this.state.choices, level: this.state.seenLevel?.()}));
      },
    };
  }

  draw(context, {view, colors, recording}) {
    if (!this.ghost) return;
    const [x, y, yaw] = this.ghost;
    const [px, py] = toScreen(view, x, y);
    const radius = Math.max(recording.header.robot_radius_m * view.scale, 9);
    context.save();
    context.translate(px, py);
    context.rotate(-yaw);
    context.strokeStyle = colors.mark;
    context.setLineDash([5, 4]);
    context.lineWidth = 2.5;
    context.beginPath();
    context.arc(0, 0, radius, 0, 2 * Math.PI);
    context.moveTo(0, 0);
    context.lineTo(2 * radius, 0);
    context.stroke();
    context.restore();
  }
}
