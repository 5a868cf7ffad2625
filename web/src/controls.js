// Buttons, choices and what they are called.
import {clockText, element} from './dom.js';
import {icon} from './icons.js';
import {kHelp} from './keys.js';
import {kSpeeds} from './playback.js';

export const kLayers = [
  ['truth', 'truth'], ['estimates', 'estimates'], ['particles', 'particles'], ['scan', 'scan'],
  ['people', 'people'], ['trails', 'last 12 s'], ['paths', 'whole paths'],
];

function button(label, picture, act) {
  return element('button', {type: 'button', 'aria-label': label, title: label, click: act}, icon(picture));
}

function choice(label, entries, act) {
  const select = element('select', {'aria-label': label, change: () => act(select.value)},
    ...entries.map(([value, text]) => element('option', {value}, text)));
  return select;
}

/** Play, step and speed. `act(action, argument)` does what is asked for. */
export function transport(act) {
  const play = button('Play', 'play', () => act('toggle'));
  play.classList.add('play');
  const speed = choice('Speed', kSpeeds.map((s) => [s, `${s} ×`]), (value) => act('speed', Number(value)));
  const clock = element('output', {class: 'clock', 'aria-live': 'off'});
  const row = element('div', {class: 'transport'},
    button('First scan (home)', 'first', () => act('seek', -Infinity)),
    button('A scan back (left arrow)', 'back', () => act('step', -1)), play,
    button('A scan on (right arrow)', 'on', () => act('step', 1)),
    button('Last scan (end)', 'last', () => act('seek', Infinity)), speed, clock);
  return {row, show(playback) {
    const label = playback.playing ? 'Pause' : 'Play';
    if (play.getAttribute('aria-label') !== label) {
      play.replaceChildren(icon(playback.playing ? 'pause' : 'play'));
      play.setAttribute('aria-label', label);
      play.title = `${label} (space)`;
    }
    speed.value = playback.speed;
    clock.textContent = `${clockText(playback.time)} / ${clockText(playback.end)}`;
  }};
}

/**
 * On and off for each layer, which localizer is shown, which floor, and whose error colours the path where `state` has
 * `errorOf`; `heights` [m]: of the floors.
 */
export function layerChoices(state, names, act, heights = []) {
  const boxes = kLayers.map(([layer, text]) => {
    const box = element('input', {type: 'checkbox', checked: state.show.has(layer), change: () => {
      if (box.checked) state.show.add(layer);
      else state.show.delete(layer);
      act('draw');
    }});
    return element('label', {}, box, text);
  });
  const floor = choice('Floor shown',
    [[-1, 'floor of the robot'], ...heights.map((z, level) => [level, `level ${level}: ${z.toFixed(2)} m`])],
    (value) => {
      state.level = Number(value);
      act('draw');
    });
  const of = choice('Localizers shown', [[-1, 'all localizers'], ...names.map((n, k) => [k, n])],
    (value) => {
      state.of = Number(value);
      act('draw');
    });
  const errorOf = choice('Localizer whose error colours the path',
    [[-1, 'path without errors'], ...names.map((n, k) => [k, `path by the error of ${n}`])],
    (value) => {
      state.errorOf = Number(value);
      act('draw');
    });
  const scanAt = choice('Where the scan is drawn',
    [[-1, 'scan where the robot is'], ...names.map((n, k) => [k, `scan where ${n} says it is`])],
    (value) => {
      state.scanAt = Number(value);
      act('draw');
    });
  return element('div', {class: 'layers', role: 'group', 'aria-label': 'What the map shows'},
    ...boxes, ...(heights.length > 1 ? [floor] : []), ...(names.length > 1 ? [of] : []), ...(names.length ? [scanAt] : []),
    ...(names.length && state.errorOf !== undefined ? [errorOf] : []));
}

/** The buttons over the map, and `more` of them. */
export function mapButtons(act, ...more) {
  const follow = button('Follow the robot (f)', 'follow', () => act('follow'));
  const row = element('div', {class: 'map-buttons'},
    button('Closer (+)', 'closer', () => act('zoom', 1.25)),
    button('Farther (−)', 'farther', () => act('zoom', 0.8)),
    button('Whole map (0)', 'whole', () => act('fit')), follow, ...more);
  return {row, show: (following) => follow.setAttribute('aria-pressed', String(following))};
}

export function help() {
  return element('details', {class: 'keys'}, element('summary', {}, 'Keys'),
    element('dl', {}, ...kHelp.flatMap(([key, text]) =>
      [element('dt', {}, key), element('dd', {}, text)])));
}
