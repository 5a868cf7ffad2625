// People between scans, and how their feet move: the page knows where people are, not their feet.

const kWalkRatio = 0.0062 * 60;  // [m s] Length of a step per steps a second, as in sim/people/gait.cpp.
const kStanding = 0.1;  // [m/s]
const kJump = 1.0;  // [m] A longer way between two scans is no walk.
const kAhead = 0.25;  // [s] People are carried on for so long after the newest scan.

/** Length of a step from one foot to the other at a speed [m/s]. [m] */
export function stepLength(speed) {
  return Math.sqrt(kWalkRatio * speed);
}

/** How far each foot is ahead of the body, after a way of `walked` [m]: on the floor it stays behind, then swings. */
export function feetAhead(walked, speed) {
  if (speed < kStanding) return [0, 0];
  const step = stepLength(speed);
  const phase = (((walked / (2 * step)) % 1) + 1) % 1;
  const swing = (at) => step * (at < 0.5 ? 0.5 - 2 * at : 2 * at - 1.5);
  return [swing(phase), swing((phase + 0.5) % 1)];
}

function turnBetween(a, b) {
  return Math.atan2(Math.sin(b - a), Math.cos(b - a));
}

/**
 * People at `time` from lists of people at times `t0` <= `t1`; after `t1` they are carried on. Each gets the speed [m/s] that
 * it has between the two.
 */
export function peopleBetween(before, t0, after, t1, time) {
  const span = t1 - t0;
  const share = span > 0 ? Math.min(time - t0, span + kAhead) / span : 1;
  return after.map((person) => {
    const old = before.find(({id}) => id === person.id);
    const [dx, dy] = old ? [person.x - old.x, person.y - old.y] : [0, 0];
    const way = Math.hypot(dx, dy);
    if (!old || span <= 0 || way > kJump) return {...person, speed: 0};
    const turn = turnBetween(old.yaw, person.yaw);
    return {...person, x: old.x + share * dx, y: old.y + share * dy, yaw: old.yaw + Math.min(share, 1) * turn, speed: way / span};
  });
}

/** Counts the way of each person from picture to picture. */
export class Walks {
  constructor() {
    this.of = new Map();
  }

  /** The people, each with the way that it has `walked`. [m] */
  add(people) {
    return people.map((person) => {
      const last = this.of.get(person.id);
      const way = last ? Math.hypot(person.x - last.x, person.y - last.y) : 0;
      const walked = (last?.walked ?? person.id) + (way < kJump ? way : 0);
      this.of.set(person.id, {x: person.x, y: person.y, walked});
      return {...person, walked};
    });
  }
}

/**
 * Where the parts of a person are, whose `model` is that of tools/build/scene/person_model.hpp: feet [x, y], left and right; hips
 * [x, y, z]; girth of the legs relative to the model's; the coat's [height of its frame, stretch]; height of the head's frame.
 */
export function partsOf(model, {id, x, y, yaw, speed, walked}) {
  const [height, legRadius] = model.bodies[id] ?? model.body;
  const [ax, ay] = [Math.cos(yaw), Math.sin(yaw)];
  const feet = feetAhead(walked, speed).map((ahead, side) => {
    const left = side === 0 ? model.foot_side : -model.foot_side;
    return [x + ahead * ax - left * ay, y + ahead * ay + left * ax];
  });
  const hips = [model.hip_side, -model.hip_side].map((left) => [x - left * ay, y + left * ax, model.hip]);
  const torso = model.torso_bottom;
  const stretch = (height - model.head_height - torso) / (model.body[0] - model.head_height - torso);
  return {feet, hips, girth: legRadius / model.body[1], coat: [torso * (1 - stretch), stretch], head: height - model.body[0]};
}
