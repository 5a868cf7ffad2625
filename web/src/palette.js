// Colours of the theme, from the page's style, and what tells things apart without colour.

/** Lines of the localizers, by style. [px] drawn and left out in turn */
export const kDashes = [[], [8, 4], [2, 3], [10, 3, 2, 3], [14, 5], [5, 2, 1, 2]];

export const kCorners = [0, 4, 3, 4, 5, 6];  // Of the localizers' outlines, by style; 0: a circle.
export const kTurns = [0, Math.PI / 4, 0, 0, 0, 0];

const kKnown = {mh_amcl: 0, amcl: 1, 'amcl-recovery': 4, 'amcl-global': 5, 'amcl-prob': 3};
const kStyles = 6;
const kFirstOfOthers = 2;  // 0 and 1 are those of mh_amcl and amcl.

/** FNV-1a of 32 bits. */
function hashOf(name) {
  let hash = 2166136261;
  for (const byte of new TextEncoder().encode(name)) hash = Math.imul(hash ^ byte, 16777619) >>> 0;
  return hash;
}

/** The first free style from `wanted` on, those of mh_amcl and amcl last; `wanted` if none is free. */
function freeStyle(wanted, taken) {
  const others = kStyles - kFirstOfOthers;
  const first = Math.max(wanted, kFirstOfOthers) - kFirstOfOthers;
  const order = [...Array(others).keys()].map((i) => kFirstOfOthers + (first + i) % others);
  return [...order, 0, 1].find((style) => !taken.has(style)) ?? wanted;
}

/**
 * Index into the palette of each localizer. It follows from the name, so that a localizer looks the same in every run.
 * tools/outputs/pictures/localizer_styles.hpp is the same function.
 */
export function stylesOf(names) {
  const taken = new Set();
  const styles = names.map((name) => {
    const known = Object.hasOwn(kKnown, name) ? kKnown[name] : -1;
    if (known < 0 || taken.has(known)) return -1;
    taken.add(known);
    return known;
  });
  return styles.map((style, i) => {
    if (style >= 0) return style;
    const hashed = kFirstOfOthers + hashOf(names[i]) % (kStyles - kFirstOfOthers);
    const free = freeStyle(Object.hasOwn(kKnown, names[i]) ? kKnown[names[i]] : hashed, taken);
    taken.add(free);
    return free;
  });
}

const kStylesOfLists = new WeakMap();

/** The style of localizer `k` of a list of names that does not change. */
export function styleOf(names, k) {
  if (!kStylesOfLists.has(names)) kStylesOfLists.set(names, stylesOf(names));
  return kStylesOfLists.get(names)[k];
}

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
  colors.errors = [0, 1, 2, 3, 4, 5].map((i) => value(`--e${i}`));
  return colors;
}

/** Colour `index`, from the beginning again behind the end. */
export function pick(colors, index) {
  return colors[((index % colors.length) + colors.length) % colors.length];
}

/** The colour of a population of particles: a shade of its localizer's, as in the pictures. */
export function shade(color, id) {
  const [factor, offset] = [[1, 0], [0.62, 0], [0.55, 0.45 * 255]][((id % 3) + 3) % 3];
  const parts = rgb(color).map((part) => Math.round(factor * part + offset));
  return `#${parts.map((part) => part.toString(16).padStart(2, '0')).join('')}`;
}

/** The outline of a localizer of this style about the origin, as a path of the context: circle, square... */
export function outline(context, style, radius) {
  const corners = pick(kCorners, style);
  context.beginPath();
  if (corners === 0) {
    context.arc(0, 0, radius, 0, 2 * Math.PI);
    return;
  }
  for (let i = 0; i < corners; ++i) {
    const angle = pick(kTurns, style) + (2 * Math.PI * i) / corners;
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
