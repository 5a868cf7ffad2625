// The moment at which the player opens.

/** Seconds of "#t=12.3"; null where the address asks for none. */
export function hashTime(hash) {
  const found = /^#t=(\d+(\.\d+)?)$/.exec(hash);
  return found ? Number(found[1]) : null;
}

/** The first scan from `event` [s] on, so that what it did is seen; null where there is none. `times`: of the scans. */
export function openingTime(event, times) {
  if (event === null) return null;
  return times.find((time) => time >= event) ?? null;
}
