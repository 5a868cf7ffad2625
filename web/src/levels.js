// The floors of a run on several of them, as tools/base/formats/level_map.hpp has them.

const kAbove = 0.5;  // [m] A ramp's last piece belongs to the floor above.
const kHead = 1.9;  // [m] Above a floor, the 3-D view is cut here.

/** Index of the floor on which something at the height `z` [m] is. `heights`: of the floors, ascending. [m] */
export function levelAt(heights, z) {
  let found = 0;
  for (let i = 1; i < heights.length; ++i) {
    if (heights[i] <= z + kAbove) found = i;
  }
  return found;
}

/** Height of the robot, or of where the first localizer believes that it is. [m] */
function robotHeight({recording, live}, scan) {
  if (live?.lift) return live.lift[0];
  const track = recording.truth.known[scan] ? recording.truth : recording.localizers[0];
  return track?.z?.[scan] ?? 0;
}

/**
 * What is seen of a run at a scan: {level: index or -1, map, section: with its cells, onLevel(z), ceiling [m]}. `chosen`: a
 * floor, or -1 for the robot's.
 */
export function floorOf(state, recording, scan, chosen = state.level ?? -1) {
  const {levels, map} = recording.header;
  if (!levels) return {level: -1, map, section: 'map', onLevel: () => true, ceiling: Infinity};
  const height = robotHeight({recording, live: state.live}, scan);
  const level = chosen >= 0 ? chosen : levelAt(levels.z_m, height);
  const many = levels.z_m.length > 1;
  return {
    level, map: levels.map, section: `level/${level}`,
    onLevel: (z) => !many || levelAt(levels.z_m, z ?? 0) === level,
    ceiling: many ? (chosen >= 0 ? levels.z_m[chosen] : height) + kHead : Infinity,
  };
}
