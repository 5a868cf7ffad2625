// Colours of the theme, from the page's style, and what tells things apart without colour.

/** Lines of the localizers, in their order. [px] drawn and left out in turn */
export const kDashes = [[], [8, 4], [2, 3], [10, 3, 2, 3], [14, 5], [5, 2, 1, 2]];

export const kCorners = [0, 4, 3, 4, 5, 6];  // Of the localizers' outlines; 0: a circle.
export const kTurns = [0, Math.PI / 4, 0, 0, 0, 0];

/** The theme's colours now. */
export function palette(element = document.documentElement) {
  const style = getComputedStyle(element);
  const value = (name) => style.getPropertyValue(name).trim();
  const colors = {};
  for (const name of ['ink', 'soft', 'line', 'card', 'page', 'mark', 'free', 'wall', 'unknown',
    'scan', 'person', 'good', 'bad', 'warn']) {
    colors[name] = value(`--${name}`);
  }
  colors.localizers = [0, 1, 2, 3, 4, 5].map((i) => value(`--c${i}`));
  colors.populations = [0, 1, 2, 3, 4, 5].map((i) => value(`--p${i}`));
  return colors;
}

/** Colour `index`, from the beginning again behind the end. */
export function pick(colors, index) {
  return colors[((index % colors.length) + colors.length) % colors.length];
}

/** The outline of localizer `k` about the origin, as a path of the context: circle, square... */
export function outline(context, k, radius) {
  const corners = pick(kCorners, k);
  context.beginPath();
  if (corners === 0) {
    context.arc(0, 0, radius, 0, 2 * Math.PI);
    return;
  }
  for (let i = 0; i < corners; ++i) {
    const angle = pick(kTurns, k) + (2 * Math.PI * i) / corners;
    context.lineTo(1.15 * radius * Math.cos(angle), 1.15 * radius * Math.sin(angle));
  }
  context.closePath();
}

/** Red, green and blue of "#rrggbb" or "#rgb". */
export function rgb(color) {
  const digits = color.replace('#', '');
  const each = digits.length === 3 ? [...digits].map((d) => d + d) : digits.match(/../g);
  return each.map((pair) => parseInt(pair, 16));
}
