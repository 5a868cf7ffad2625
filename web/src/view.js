// Where the map stands on the canvas: metres in map to pixels, y up to y down.

const kLeast = 2;  // [px/m]
const kMost = 2000;

/** A view that shows `bounds` = {left, bottom, right, top} [m] on a canvas of this size [px]. */
export function fitted(bounds, width, height, margin = 12) {
  const wide = Math.max(bounds.right - bounds.left, 0.1);
  const high = Math.max(bounds.top - bounds.bottom, 0.1);
  const scale = Math.min((width - 2 * margin) / wide, (height - 2 * margin) / high);
  return {
    x: (bounds.left + bounds.right) / 2,
    y: (bounds.bottom + bounds.top) / 2,
    scale: Math.max(scale, 0.1),
    width,
    height,
  };
}

/** Pixels of a point in map. */
export function toScreen(view, x, y) {
  return [view.width / 2 + (x - view.x) * view.scale, view.height / 2 - (y - view.y) * view.scale];
}

/** The point in map at pixels. */
export function toMap(view, px, py) {
  return [view.x + (px - view.width / 2) / view.scale, view.y - (py - view.height / 2) / view.scale];
}

/** Closer by `factor`, the point at pixels kept where it is. */
export function zoomed(view, factor, px = view.width / 2, py = view.height / 2) {
  const scale = Math.min(kMost, Math.max(Math.min(kLeast, view.scale), view.scale * factor));
  const [x, y] = toMap(view, px, py);
  return {
    ...view,
    scale,
    x: x - (px - view.width / 2) / scale,
    y: y + (py - view.height / 2) / scale,
  };
}

/** Moved by pixels, as a hand moves the map. */
export function panned(view, dx, dy) {
  return {...view, x: view.x - dx / view.scale, y: view.y + dy / view.scale};
}

/** The same place and scale on a canvas of another size. */
export function resized(view, width, height) {
  return {...view, width, height};
}

/** What a map's header covers. [m] */
export function boundsOf(map) {
  const [x0, y0, yaw] = map.origin;
  const wide = map.width * map.resolution_m;
  const high = map.height * map.resolution_m;
  const xs = [];
  const ys = [];
  for (const [u, v] of [[0, 0], [wide, 0], [0, high], [wide, high]]) {
    xs.push(x0 + u * Math.cos(yaw) - v * Math.sin(yaw));
    ys.push(y0 + u * Math.sin(yaw) + v * Math.cos(yaw));
  }
  return {
    left: Math.min(...xs), right: Math.max(...xs), bottom: Math.min(...ys), top: Math.max(...ys),
  };
}

/** A round length for a scale bar of about `px` pixels. [m] */
export function barLength(view, px = 110) {
  const rough = px / view.scale;
  const power = 10 ** Math.floor(Math.log10(rough));
  return [5, 2, 1].map((f) => f * power).find((length) => length <= rough) ?? power;
}
