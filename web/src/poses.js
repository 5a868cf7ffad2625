// Where things are between scans.
import {wrapped} from './measures.js';

const kJump = 0.6;  // [m] A longer way between two scans is a jump: nothing moves along it, or up and down.
const kGap = 1.0;  // [s]

/** The pose at scan `i`: {x, y, yaw}; on several floors with z, and `lift`: [z, roll, pitch], if the track has it. */
function poseOf(track, i) {
  const pose = {x: track.x[i], y: track.y[i], yaw: track.yaw[i]};
  if (!track.z) return pose;
  return {...pose, z: track.z[i], ...(track.roll && {lift: [track.z[i], track.roll[i], track.pitch[i]]})};
}

/** The pose of a track at `time`, between scan `i` and the next; null where there is none. */
export function poseAt(track, times, i, time) {
  if (!track.known[i]) return null;
  const pose = poseOf(track, i);
  const next = i + 1;
  if (next >= times.length || !track.known[next] || time <= times[i]) return pose;
  const to = poseOf(track, next);
  const [dx, dy, dz] = [to.x - pose.x, to.y - pose.y, (to.z ?? 0) - (pose.z ?? 0)];
  const span = times[next] - times[i];
  if (Math.hypot(dx, dy, dz) > kJump || span > kGap || span <= 0) return pose;
  const part = Math.min(1, (time - times[i]) / span);
  const turn = wrapped(to.yaw - pose.yaw);
  const between = {...pose, x: pose.x + part * dx, y: pose.y + part * dy, yaw: pose.yaw + part * turn};
  if (!track.z) return between;
  return {...between, z: pose.z + part * dz, ...(pose.lift && {lift: pose.lift.map((value, k) => value + part * (to.lift[k] - value))})};
}

/**
 * Pieces of the way from scan `from` to scan `to`, without its jumps: [[x, y, x, y...]...]. `keep(z)`: of the parts that
 * are wanted. `heights` gets the heights of the same points, `scans` their scans, if they are given: [[z, z...]...].
 */
export function pieces(track, from, to, keep = () => true, heights = null, scans = null) {
  const found = [];
  let last = null;
  for (let i = from; i <= to; ++i) {
    const z = track.z?.[i] ?? 0;
    if (!track.known[i] || !keep(z)) {
      last = null;
      continue;
    }
    const joined = last && Math.hypot(track.x[i] - last[0], track.y[i] - last[1], z - last[2]) <= kJump;
    if (!joined) {
      found.push([]);
      heights?.push([]);
      scans?.push([]);
    }
    last = [track.x[i], track.y[i], z];
    found.at(-1).push(last[0], last[1]);
    heights?.at(-1).push(z);
    scans?.at(-1).push(i);
  }
  return found;
}
