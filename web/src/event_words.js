// What happened, in words for readers: the one table of them, for event lists, marks and banners.

const number = (value) => String(Number(value.toFixed(1)));

/** "at 1.2, 3.4", or nothing. */
const at = (place) => (place ? ` at ${number(place[0])}, ${number(place[1])}` : '');
const to = (place) => (place ? ` to ${number(place[0])}, ${number(place[1])}` : '');

/** Kidnaps by `detail`. */
const kKidnaps = {
  teleport: (place) => `put${at(place)}`,
  teleport_to: (place) => `put${at(place)}`,
  look_alike: (place) => `put${at(place)}, which looks alike`,
  nudge: (place) => `pushed${to(place)}`,
  turn: () => 'turned in place',
  carry: (place) => `carried${to(place)}`,
  spin: () => 'lifted while the wheels turn',
  elevator: (place) => `taken by a lift${to(place)}`,
  pallet_truck: (place) => `taken by a pallet truck${to(place)}`,
  splice: (place) => `the log goes on${at(place) || ' elsewhere'}`,
};

/** Faults by kind; `detail` may name a lidar after it. */
const kFaults = {
  'lidar-dropout': 'no scans',
  'lidar-frozen': 'scans frozen',
  'lidar-blocked': 'lidar covered',
  'lidar-mount': 'lidar turned or moved',
  'lidar-late': 'scans late',
  'lidar-clock': 'lidar clock wrong',
  'odometry-frozen': 'odometry frozen',
  'odometry-scale': 'odometry too far or too short',
  'odometry-reversed': 'a wheel counts backwards',
  'odometry-dropout': 'no odometry',
  'odometry-reset': 'odometry reset',
};

const kOrders = {
  initialize: 'is told where it is',
  relocalize: 'is told to search everywhere (global localization)',
  off: 'is switched off',
  on: 'is switched on',
};

const kRecoveries = {'from kidnap': 'is right again after a kidnap', 'from unknown start': 'is right for the first time'};

/** A fault's `detail` in words: "lidar covered", "lidar covered (front)". */
export function faultWords(detail) {
  const [kind, ...lidar] = detail.split(' ');
  const words = kFaults[kind] ?? kind;
  return lidar.length > 0 ? `${words} (${lidar.join(' ')})` : words;
}

/** "box-1 placed" of "box-1 put", "gate opened by 90°" of "gate open by 90 deg". */
function worldWords(detail) {
  return detail.replace(/ put$/, ' placed').replace(/ open by (\S+) deg$/, ' opened by $1°');
}

function driveWords({v, w} = {}) {
  return v === undefined ? 'drives along its route again' : `driven by hand: ${v} m/s, ${w} rad/s`;
}

/** By kind of event: what is said of it. What is about a localizer begins with its name. */
const kWords = {
  kidnap: ({detail, to: place}) => `kidnap: ${kKidnaps[detail]?.(place) ?? detail}`,
  'pick-up': () => 'lifted',
  collision: ({detail}) => `collision${detail && ` with ${detail}`}`,
  'fault on': ({detail}) => `fault: ${faultWords(detail)}`,
  'fault off': ({detail}) => `fault over: ${faultWords(detail)}`,
  driving: ({detail}) => `driver: ${detail}`,
  void: ({detail}) => `the run is void: ${detail.replaceAll('_', ' ')}`,
  'alarm on': () => 'says that it is lost',
  'alarm off': () => 'no longer says that it is lost',
  recovery: ({detail}) => kRecoveries[detail] ?? `is right again ${detail}`,
  operator: ({detail}) => kOrders[detail] ?? detail,
  'localizer failed': ({detail}) => `failed: ${detail}`,
  node: ({detail}) => detail,
  world: ({detail}) => worldWords(detail),
  warning: ({detail}) => detail,
  drive: ({drive}) => driveWords(drive),
};

/** An event in words, without its time. */
export function wordsOf(event) {
  const words = kWords[event.kind]?.(event) ?? [event.kind, event.detail && `(${event.detail})`].filter(Boolean).join(' ');
  return [event.localizer, words].filter(Boolean).join(' ');
}

/** Faults that are there at `time`, in words; of events in the order in which they happened. */
export function faultsAt(events, time) {
  const faults = new Map();
  for (const {kind, detail, time: began} of events) {
    if (began > time + 1e-6 || detail.startsWith('odometry-reset')) continue;
    if (kind === 'fault on') faults.set(detail, (faults.get(detail) ?? 0) + 1);
    if (kind === 'fault off') faults.set(detail, (faults.get(detail) ?? 1) - 1);
  }
  return [...faults].filter(([, count]) => count > 0).map(([detail]) => faultWords(detail));
}
