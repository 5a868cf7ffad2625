// Colours of position errors on paths.

const kEnds = [0.1, 0.2, 0.5, 1, 5];  // [m] Not included.

/** The step of a position error [m], 0 to 5, as tools/pages/html/error_scale.hpp has it; -1 for none. */
export function errorStep(error) {
  if (error === null || error === undefined) return -1;
  const step = kEnds.findIndex((end) => error < end);
  return step < 0 ? kEnds.length : step;
}

/** What each colour stands for. [m] */
export const kErrorWords = [`below ${kEnds[0]}`, ...kEnds.slice(1).map((end, i) => `${kEnds[i]} to ${end}`),
  `from ${kEnds.at(-1)}`];

/**
 * A path in pieces of one colour: [{step, points: [x, y, x, y...]}]. `parts`: pieces without jumps, as poses.js finds
 * them; `errors`: of their points, [[error...]...]. The stretch to a point has the colour of that point.
 */
export function errorPieces(parts, errors) {
  const found = [];
  parts.forEach((part, p) => {
    for (let i = 1; 2 * i < part.length; ++i) {
      const step = errorStep(errors[p][i]);
      const last = found.at(-1);
      if (i > 1 && last?.step === step) last.points.push(part[2 * i], part[2 * i + 1]);
      else found.push({step, points: [part[2 * i - 2], part[2 * i - 1], part[2 * i], part[2 * i + 1]]});
    }
  });
  return found;
}
