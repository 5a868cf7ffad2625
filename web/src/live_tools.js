// The tools of a live run: what hands can do to robot, sensors and localizers.
import {element} from './dom.js';
import {kTools, touchEvent} from './live_hands.js';
import {isOpen} from './world_changes.js';

/** Kidnaps that need no place. */
const kKidnaps = [
  ['Anywhere', {kidnap: {kind: 'teleport', min_distance_m: 2}}],
  ['To a look-alike', {kidnap: {kind: 'look_alike', min_distance_m: 1}}],
  ['Push', {kidnap: {kind: 'nudge'}}],
  ['Turn', {kidnap: {kind: 'turn'}}],
  ['Spin the wheels', {kidnap: {kind: 'spin'}}],
];

/** Faults, with what they need beyond a duration. */
const kFaults = {
  'lidar covered': {kind: 'lidar-blocked', from_deg: -180, to_deg: 180},
  'lidar half covered': {kind: 'lidar-blocked', from_deg: 0, to_deg: 180},
  'no scans': {kind: 'lidar-dropout'},
  'scans frozen': {kind: 'lidar-frozen'},
  'scans late by 0.5 s': {kind: 'lidar-late', delay_s: 0.5},
  'lidar turned by 10°': {kind: 'lidar-mount', yaw_deg: 10},
  'lidar clock 0.2 s fast': {kind: 'lidar-clock', offset_s: 0.2},
  'odometry frozen': {kind: 'odometry-frozen'},
  'no odometry': {kind: 'odometry-dropout'},
  'odometry 20 % too far': {kind: 'odometry-scale', scale: 1.2},
  'a wheel counts backwards': {kind: 'odometry-reversed'},
  'odometry reset': {kind: 'odometry-reset'},
};

/** The event of a fault; a reset has no duration. */
export function faultEvent(name, seconds) {
  const fault = kFaults[name];
  return {fault: fault.kind === 'odometry-reset' ? fault : {...fault, for_s: seconds}};
}

function button(text, act, more = {}) {
  return element('button', {type: 'button', click: act, ...more}, text);
}

function choice(label, values, act) {
  const select = element('select', {'aria-label': label, change: () => act?.(select.value)},
    ...values.map((value) => element('option', {value}, value)));
  return select;
}

function group(name, ...parts) {
  return element('fieldset', {class: 'tools'}, element('legend', {}, name), element('div', {class: 'row'}, ...parts));
}

/** Tools of the pointer: one of them, or none, is chosen. */
function pointerTools(tools, state, help) {
  const buttons = tools.map(([name, {text, help: words}]) =>
    button(text, () => {
      state.tool = state.tool === name ? null : name;
      help.textContent = state.tool ? words : 'The pointer moves the map.';
      show();
    }, {'data-tool': name, title: words}));
  function show() {
    for (const each of buttons) each.setAttribute('aria-pressed', String(each.dataset.tool === state.tool));
  }
  show();
  return buttons;
}

/** People by name: how they come. */
const kPeople = {
  'a person who stands': {count: 1, walk: false},
  'a person who walks': {count: 1, walk: true},
  'three who talk': {count: 3, walk: false},
  'three who walk together': {count: 3, walk: true},
};

const kAhead = 1.2;  // [m] Where a button puts things before the robot.

/** The event that puts something before the robot. */
export function aheadEvent(tool, {x, y, yaw}, choices) {
  const pose = [x + kAhead * Math.cos(yaw), y + kAhead * Math.sin(yaw), yaw];
  return kTools[tool].event(pose, choices);
}

/** Tools for the world, which also work without a pointer. */
function worldTools(state, send) {
  const people = choice('People who come', Object.keys(kPeople), (name) => {
    state.choices.people = kPeople[name];
  });
  const ahead = (tool) => () => state.live && send(aheadEvent(tool, state.live.truth, state.choices));
  const things = choice('Doors and boxes', []);
  const touch = button('Open', () => send(touchEvent(things.value, state.things().get(things.value))));
  const show = () => {
    const thing = state.things().get(things.value);
    touch.disabled = !thing;
    touch.textContent = !thing?.door ? 'Take away' : isOpen(thing) ? 'Close' : 'Open';
  };
  things.addEventListener('change', show);
  const parts = group('World', people, button('People ahead', ahead('person')), button('Box ahead', ahead('box')), things, touch);
  const showThings = (all) => {
    const chosen = things.value;
    things.replaceChildren(...[...all.keys()].map((name) => element('option', {value: name}, name)));
    if (all.has(chosen)) things.value = chosen;
    things.hidden = touch.hidden = all.size === 0;
    show();
  };
  return {parts, showThings};
}

/** What can be done to a log of `scans` scans: it is spliced. */
function logTools(scans, send) {
  const scan = element('input', {type: 'number', min: 0, max: scans - 1, step: 1, value: 0, 'aria-label': 'Scan of the log'});
  const go = () => send({splice: {to_scan: Number(scan.value)}});
  return group('Log', scan, `of ${scans} scans`, button('Go on from this scan', go));
}

const kOfLogs = ['teleport', 'initial'];  // Tools of the pointer for recorded logs.

/**
 * All tools: {panel, showThings(things)}. `state`: {tool, choices}; `send(event)`: an event takes place. `recorded`:
 * {scans} of a log that is played, which has no world, undefined for a simulated run.
 */
export function liveTools(state, names, send, recorded) {
  const help = element('p', {class: 'soft', role: 'status'}, recorded
    ? 'Drag the robot: the log goes on from the scan nearest to there.' : 'Drag the robot; a kidnap that takes no time.');
  const seconds = element('input', {type: 'number', min: 0.5, max: 600, step: 0.5, value: 5,
    'aria-label': 'Duration of the fault [s]'});
  const fault = choice('Fault', Object.keys(kFaults));
  const localizer = choice('Localizer', names, (name) => {
    state.choices.localizer = name;
  });
  const order = (what) => () => send({localizer: {name: localizer.value, do: what}});
  const world = worldTools(state, send);
  const pointer = Object.entries(kTools).filter(([name]) => !recorded || kOfLogs.includes(name));
  const kidnaps = recorded ? kKidnaps.slice(0, 2) : kKidnaps;
  const tools = [
    group('Hands', ...pointerTools(pointer, state, help), help),
    group('Kidnap', ...kidnaps.map(([text, event]) => button(text, () => send(event)))),
    ...(recorded ? [logTools(recorded.scans, send)] : [world.parts,
      group('Break', fault, seconds, button('Break it', () => send(faultEvent(fault.value, Number(seconds.value)))))]),
  ];
  if (names.length > 0) {
    tools.push(group('Localizer', localizer, button('Global localization', order('relocalize')),
      button('Off', order('off')), button('On', order('on'))));
  }
  return {panel: element('div', {class: 'live-tools'}, ...tools), showThings: world.showThings};
}
