// What is broken at the time that is shown, over the map.
import {element} from './dom.js';
import {faultsAt} from './event_words.js';

export class FaultBanner {
  constructor() {
    this.line = element('p', {class: 'faults', role: 'status', hidden: true});
  }

  /** `events`: of the run, in order. */
  show(events, time) {
    const text = faultsAt(events, time).join(' · ');
    if (text === this.text) return;
    this.text = text;
    this.line.hidden = text === '';
    this.line.textContent = text && `Broken: ${text}`;
  }
}
