// Beams, particles and people of one scan, as tools/outputs/records/recording_blocks.hpp writes them.

/** The lidar's index and its beams' ranges [m], NaN where nothing came back. */
export function beamsOf(recording, position) {
  const reader = recording.block('beams', position);
  const lidar = reader.next();
  const ranges = [];
  for (let value = 0; !reader.done;) {
    value += reader.nextSigned();
    ranges.push(value === 0 ? NaN : (value - 1) * recording.header.steps.point);
  }
  return {lidar, ranges};
}

/** Ends of beams in base, x and y in turn. [m] */
export function beamEnds(lidar, ranges) {
  const T = lidar.T_base_laser;
  const ends = [];
  ranges.forEach((range, i) => {
    if (Number.isNaN(range)) return;
    const angle = lidar.angle_min_rad + i * lidar.angle_increment_rad;
    const x = range * Math.cos(angle);
    const y = range * Math.sin(angle);
    ends.push(T[0] * x + T[1] * y + T[3], T[4] * x + T[5] * y + T[7]);
  });
  return ends;
}

/** The same with heights: x, y and z in turn. [m] */
export function beamPoints(lidar, ranges) {
  const T = lidar.T_base_laser;
  const points = [];
  ranges.forEach((range, i) => {
    if (Number.isNaN(range)) return;
    const angle = lidar.angle_min_rad + i * lidar.angle_increment_rad;
    const [x, y] = [range * Math.cos(angle), range * Math.sin(angle)];
    for (const row of [0, 4, 8]) points.push(T[row] * x + T[row + 1] * y + T[row + 3]);
  });
  return points;
}

function poseOf(reader, steps) {
  return {
    x: reader.nextSigned() * steps.point,
    y: reader.nextSigned() * steps.point,
    yaw: reader.nextSigned() * steps.angle,
  };
}

/** The populations of localizer `k`; `points`: particles in map, x and y in turn. [m] */
export function populationsOf(recording, k, position) {
  const {steps} = recording.header;
  const reader = recording.block(`${k}/points`, position);
  const populations = [];
  for (let left = reader.next(); left > 0; --left) {
    const population = {
      id: reader.nextSigned(),
      selected: reader.next() === 1,
      share: reader.nextSigned() * steps.share,
      quality: reader.nextSigned() * steps.share,
      ...poseOf(reader, steps),
      ...(recording.header.heights && {z: reader.nextSigned() * steps.point}),
      points: [],
    };
    let {x} = population;
    for (let particles = reader.next(); particles > 0; --particles) {
      x += reader.nextSigned() * steps.point;
      population.points.push(x, population.y + reader.nextSigned() * steps.point);
    }
    populations.push(population);
  }
  return populations;
}

/** The people about. */
export function peopleOf(recording, position) {
  const reader = recording.block('people', position);
  const people = [];
  for (let left = reader.next(); left > 0; --left) {
    people.push({id: reader.nextSigned(), ...poseOf(reader, recording.header.steps)});
  }
  return people;
}
