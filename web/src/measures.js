// What is to be said of a localizer at every scan.

/** States of an output, from good to bad. */
export const kRight = 0;
export const kUnknown = 1;  // No answer, no truth, or a torn scan.
export const kSaysLost = 2;  // Wrong, and says so.
export const kFalseAlarm = 3;  // Right, but says that it is lost.
export const kWrong = 4;  // Wrong, and does not say so.

export const kStateWords = ['right', 'not scored', 'lost, and says so', 'right, but says lost',
  'wrong, and says right'];

/** The angle in (-pi, pi]. */
export function wrapped(angle) {
  const turns = Math.ceil((angle - Math.PI) / (2 * Math.PI));
  return angle - 2 * Math.PI * turns;
}

/** Whether any true pose is known; without, nothing is scored. True before the first scan. */
export function hasTruth({truth: {known}}) {
  return known.length === 0 || Array.from(known).some(Boolean);
}

/** Position and yaw error over the scans; null where there is none. [m], [rad] */
export function errorsOf(recording, localizer) {
  const {truth, torn} = recording;
  const position = [];
  const yaw = [];
  for (let i = 0; i < recording.scans; ++i) {
    const there = truth.known[i] && localizer.known[i] && !torn[i];
    const above = truth.z ? (localizer.z?.[i] ?? 0) - truth.z[i] : 0;
    position.push(there ? Math.hypot(localizer.x[i] - truth.x[i], localizer.y[i] - truth.y[i], above) : null);
    yaw.push(there ? Math.abs(wrapped(localizer.yaw[i] - truth.yaw[i])) : null);
  }
  return {position, yaw};
}

/** The state at every scan. */
export function statesOf(localizer, errors, rightM, rightRad) {
  return errors.position.map((position, i) => {
    if (position === null) return localizer.lost[i] ? kSaysLost : kUnknown;
    const right = position < rightM && errors.yaw[i] < rightRad;
    if (localizer.lost[i]) return right ? kFalseAlarm : kSaysLost;
    return right ? kRight : kWrong;
  });
}

/** Stretches of one state: [{state, from, to}] in time; the last one ends at `end`. */
export function stretches(states, times, end) {
  const found = [];
  states.forEach((state, i) => {
    const last = found.at(-1);
    if (last?.state === state) return;
    if (last) last.to = times[i];
    found.push({state, from: times[i], to: end});
  });
  return found;
}
