// A camera that looks at a target: where it stands, and what hands do to it. Frame map, z up.
//
// A camera is {target: [x, y, z] [m], azimuth: direction that it looks along, seen from above [rad], elevation: angle at
// which it looks down [rad], distance: from the target [m]}.

export const kFovDeg = 50;  // From the lower to the upper edge.

const kLowest = 0.06;  // [rad]
const kHighest = Math.PI / 2 - 1e-3;  // Straight down, "up" would have no meaning.
const kNearest = 0.5;  // [m]
const kFarthest = 400;
const kSettled = 1e-3;  // [m], [rad] Nobody sees smaller differences.

const clamped = (value, low, high) => Math.min(high, Math.max(low, value));

/** An angle in (-pi, pi]. */
export function wrapped(angle) {
  return Math.atan2(Math.sin(angle), Math.cos(angle));
}

/** Where the camera stands. [m] */
export function eyeOf({target, azimuth, elevation, distance}) {
  const level = distance * Math.cos(elevation);
  return [target[0] - level * Math.cos(azimuth), target[1] - level * Math.sin(azimuth),
    target[2] + distance * Math.sin(elevation)];
}

/** Turned about its target by angles. [rad] */
export function orbited(camera, right, up) {
  return {...camera, azimuth: wrapped(camera.azimuth - right), elevation: clamped(camera.elevation + up, kLowest, kHighest)};
}

/** Nearer by `factor`. */
export function closer(camera, factor) {
  return {...camera, distance: clamped(camera.distance / factor, kNearest, kFarthest)};
}

/** Length at the target that a pixel of a picture of this height shows. [m/px] */
export function metresPerPixel(camera, height) {
  return (2 * camera.distance * Math.tan((kFovDeg * Math.PI) / 360)) / height;
}

/** Moved over the floor, as a hand that drags the picture by pixels moves it. */
export function dragged(camera, dx, dy, height) {
  const scale = metresPerPixel(camera, height);
  const ahead = (dy * scale) / Math.max(Math.sin(camera.elevation), 0.3);
  const right = -dx * scale;
  const [cos, sin] = [Math.cos(camera.azimuth), Math.sin(camera.azimuth)];
  const [x, y, z] = camera.target;
  return {...camera, target: [x + ahead * cos + right * sin, y + ahead * sin - right * cos, z]};
}

/** A point as the camera sees it: right, up and ahead of it. [m] */
export function inCamera(camera, point) {
  const eye = eyeOf(camera);
  const [dx, dy, dz] = point.map((value, i) => value - eye[i]);
  const [cos, sin] = [Math.cos(camera.azimuth), Math.sin(camera.azimuth)];
  const [down, level] = [Math.sin(camera.elevation), Math.cos(camera.elevation)];
  const along = dx * cos + dy * sin;
  return [dx * sin - dy * cos, along * down + dz * level, along * level - dz * down];
}

/** Where in the picture a point is: x right and y up in [-1, 1], null behind the camera. */
export function inPicture(camera, point, aspect) {
  const [right, up, ahead] = inCamera(camera, point);
  if (ahead < 0.05) return null;
  const half = ahead * Math.tan((kFovDeg * Math.PI) / 360);
  return [right / (half * aspect), up / half];
}

/** The corners of a box over [x, y, x, y] up to `top`. [m] */
export function cornersOf([left, bottom, right, upper], top) {
  return [0, top].flatMap((z) => [[left, bottom, z], [right, bottom, z], [left, upper, z], [right, upper, z]]);
}

/** The camera at the least distance at which all points are within `rim` of the picture. */
export function framed(camera, points, aspect, rim = 0.94) {
  const fits = (distance) => points.every((point) => {
    const at = inPicture({...camera, distance}, point, aspect);
    return at !== null && Math.max(Math.abs(at[0]), Math.abs(at[1])) <= rim;
  });
  let [low, high] = [kNearest, kFarthest];
  for (let i = 0; i < 40; ++i) {
    const middle = 0.5 * (low + high);
    if (fits(middle)) high = middle;
    else low = middle;
  }
  return {...camera, distance: high};
}

/** A camera that shows the whole extent [x, y, x, y] of a world, from the south. */
export function overview(extent, top, aspect, elevation = 0.98) {
  const [left, bottom, right, upper] = extent;
  const middle = [(left + right) / 2, (bottom + upper) / 2, 0];
  const camera = {target: middle, azimuth: Math.PI / 2, elevation, distance: kNearest};
  // The near edge looks larger than the far one: the middle of the picture lies south of the middle of the floor.
  camera.target[1] -= 0.06 * (upper - bottom) * Math.cos(elevation);
  return framed(camera, cornersOf(extent, top), aspect);
}

/** The same from straight above, north up. */
export function fromAbove(extent, top, aspect) {
  return overview(extent, top, aspect, kHighest);
}

/** Where a camera that follows the robot begins: behind and above it. */
export const kFollowing = {azimuth: 0, elevation: 0.55, distance: 4};
const kLookAhead = 0.6;  // [m]
const kLookHeight = 0.15;

/**
 * Behind a robot at `pose`; `camera.azimuth` is relative to its yaw here. `free` [m]: level distance behind the robot up to
 * the first obstacle; in a narrow place the camera goes up instead of into the wall.
 */
export function following(camera, pose, free = Infinity) {
  const azimuth = wrapped(pose.yaw + camera.azimuth);
  const ahead = [Math.cos(pose.yaw), Math.sin(pose.yaw)];
  const level = camera.distance * Math.cos(camera.elevation);
  const room = Math.max(free, 0.35) + kLookAhead;
  const elevation = level > room ? Math.acos(clamped(room / camera.distance, 0, 1)) : camera.elevation;
  return {
    target: [pose.x + kLookAhead * ahead[0], pose.y + kLookAhead * ahead[1], kLookHeight + (pose.z ?? 0)],
    azimuth, elevation: clamped(elevation, kLowest, kHighest), distance: camera.distance,
  };
}

/** On the way from `camera` to `goal`, `share` of it; the goal itself where nobody sees a difference. */
export function eased(camera, goal, share) {
  const turn = wrapped(goal.azimuth - camera.azimuth);
  const way = goal.target.map((value, i) => value - camera.target[i]);
  const rest = Math.max(Math.abs(turn), Math.abs(goal.elevation - camera.elevation), Math.abs(goal.distance - camera.distance),
    ...way.map(Math.abs));
  if (rest * (1 - share) < kSettled) return goal;
  return {
    target: camera.target.map((value, i) => value + share * way[i]),
    azimuth: wrapped(camera.azimuth + share * turn),
    elevation: camera.elevation + share * (goal.elevation - camera.elevation),
    distance: camera.distance + share * (goal.distance - camera.distance),
  };
}
