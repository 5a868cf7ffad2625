// Where things are between scans.
import {wrapped} from './measures.js';

const kJump = 0.6;  // [m] A longer way between two scans is a jump: nothing moves along it.
const kGap = 1.0;  // [s]

/** The pose of a track at `time`, between scan `i` and the next; null where there is none. */
export function poseAt(track, times, i, time) {
  if (!track.known[i]) return null;
  const pose = {x: track.x[i], y: track.y[i], yaw: track.yaw[i]};
  const next = i + 1;
  if (next >= times.length || !track.known[next] || time <= times[i]) return pose;
  const dx = track.x[next] - pose.x;
  const dy = track.y[next] - pose.y;
  const span = times[next] - times[i];
  if (Math.hypot(dx, dy) > kJump || span > kGap || span <= 0) return pose;
  const part = Math.min(1, (time - times[i]) / span);
  const turn = wrapped(track.yaw[next] - pose.yaw);
  return {x: pose.x + part * dx, y: pose.y + part * dy, yaw: pose.yaw + part * turn};
}

/** Pieces of the way from scan `from` to scan `to`, without its jumps: [[x, y, x, y...]...]. */
export function pieces(track, from, to) {
  const found = [];
  let last = null;
  for (let i = from; i <= to; ++i) {
    if (!track.known[i]) {
      last = null;
      continue;
    }
    const joined = last && Math.hypot(track.x[i] - last[0], track.y[i] - last[1]) <= kJump;
    if (!joined) found.push([]);
    last = [track.x[i], track.y[i]];
    found.at(-1).push(...last);
  }
  return found;
}
