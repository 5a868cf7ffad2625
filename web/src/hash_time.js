// The moment that an address asks for.

/** Seconds of "#t=12.3"; null where the address asks for none. */
export function hashTime(hash) {
  const found = /^#t=(\d+(\.\d+)?)$/.exec(hash);
  return found ? Number(found[1]) : null;
}
