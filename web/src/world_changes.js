// Objects that a run's events put into its world, and its doors, at any time.

/** What stands there at `time`, by name: {outline, z, door, closed: outline of a closed door}. `header.doors`: at the beginning; `changes`: in order. */
export function worldAt(header, changes, time) {
  const found = new Map((header.doors ?? []).map((door) => [door.name, {...door, door: true}]));
  for (const change of changes) {
    if (change.time > time + 1e-9) break;
    if (change.outline.length > 0) {
      found.set(change.name, {door: false, ...found.get(change.name), ...change});
    } else {
      found.delete(change.name);
    }
  }
  return found;
}

/** How many of `changes`, in order of time, are of the object `name` and not after `time`. */
export function changesSoFar(changes, name, time) {
  return changes.filter((change) => change.name === name && change.time <= time + 1e-9).length;
}

/** True if a point is in a convex outline, counter-clockwise. */
export function isIn(outline, [x, y]) {
  return outline.length > 2 && outline.every(([ax, ay], i) => {
    const [bx, by] = outline[(i + 1) % outline.length];
    return (bx - ax) * (y - ay) - (by - ay) * (x - ax) >= 0;
  });
}

/** Distance [m] of a point from the edges of an outline, 0 inside. */
export function distanceTo(outline, [x, y]) {
  if (isIn(outline, [x, y])) return 0;
  let least = Infinity;
  outline.forEach(([ax, ay], i) => {
    const [bx, by] = outline[(i + 1) % outline.length];
    const [dx, dy] = [bx - ax, by - ay];
    const along = Math.min(1, Math.max(0, ((x - ax) * dx + (y - ay) * dy) / Math.max(dx * dx + dy * dy, 1e-12)));
    least = Math.min(least, Math.hypot(ax + along * dx - x, ay + along * dy - y));
  });
  return least;
}

/** The name of what is nearest to a point, at most `reach` [m] away; null if nothing is. */
export function nearest(things, point, reach) {
  let best = null;
  for (const [name, {outline}] of things) {
    const distance = distanceTo(outline, point);
    if (distance <= reach && (!best || distance < best.distance)) best = {name, distance};
  }
  return best?.name ?? null;
}

/** True if a door's leaf is not where it is when the door is closed. */
export function isOpen({outline, closed}) {
  return outline.some(([x, y], i) => Math.hypot(x - closed[i][0], y - closed[i][1]) > 0.05);
}
