// What the signs on map and timeline mean.
import {element} from './dom.js';
import {kErrorWords} from './error_scale.js';
import {sortsOf} from './marks.js';

function line(style, text) {
  return element('span', {class: 'key'}, element('i', {class: style, 'aria-hidden': 'true'}), text);
}

/** Signs of the map. */
export function mapLegend() {
  return element('p', {class: 'signs map-signs'}, line('ring', 'truth'), line('dot scan', 'lidar hits'),
    line('dot particle', 'particles, a shade a population'), line('dot person', 'people'),
    line('disc', 'two standard deviations about an estimate'));
}

/** Colours of the path by errors; hidden until `state.errorOf` is a localizer. */
export function errorLegend() {
  return element('p', {class: 'signs error-signs', hidden: true}, element('span', {}, 'position error [m]:'),
    ...kErrorWords.map((words, step) => element('span', {class: 'key'},
      element('i', {class: 'stroke', style: `background: var(--e${step})`, 'aria-hidden': 'true'}), words)));
}

/** Signs of the timeline. */
export function timeLegend(marks) {
  return element('p', {class: 'signs'},
    ...sortsOf(marks).map(({sort, symbol, color}) => element('span', {class: 'key'},
      element('b', {style: `color: var(--${color})`, 'aria-hidden': 'true'}, symbol), sort)),
    line('lane right', 'right'), line('lane wrong', 'wrong, and says right'),
    line('lane lost', 'says that it is lost'));
}
