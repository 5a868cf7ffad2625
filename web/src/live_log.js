// What happened in a live run, the newest first.
import {clockText, element} from './dom.js';
import {wordsOf} from './event_words.js';

const kMost = 500;

/** An event as the map and the timeline take it: places without headings. */
export function eventOf(event) {
  const place = (pose, z) => (pose ? [...pose.slice(0, 2), ...(z === undefined ? [] : [z])] : null);
  return {...event, from: place(event.from, event.from_z), to: place(event.to, event.to_z)};
}

/** The list, and the events themselves in `events`. */
export class LiveLog {
  constructor() {
    this.events = [];
    this.list = element('ol', {class: 'log', tabindex: 0, 'aria-label': 'What happened'});
  }

  /** Events from the number `first` on, as the run tells them: what was there with these numbers and later ones never happened. */
  take(first, events) {
    while (this.events.length > 0 && this.events.at(-1).number >= first) {
      this.events.pop();
      this.list.firstElementChild.remove();
    }
    const taken = events.map((event, i) => ({...eventOf(event), number: first + i}));
    for (const event of taken) this.add(event);
    return taken;
  }

  add(event) {
    this.events.push(event);
    this.list.prepend(element('li', {}, element('b', {}, clockText(event.time)), ` ${wordsOf(event)}`));
    if (this.events.length <= kMost) return;
    this.events.shift();
    this.list.lastElementChild.remove();
  }
}
