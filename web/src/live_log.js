// What happened in a live run, the newest first.
import {clockText, element} from './dom.js';

const kMost = 500;

/** An event as the map and the timeline take it: places without headings. */
export function eventOf(event) {
  const place = (pose, z) => (pose ? [...pose.slice(0, 2), ...(z === undefined ? [] : [z])] : null);
  return {...event, from: place(event.from, event.from_z), to: place(event.to, event.to_z)};
}

/** A command to drive, which is no event of the run, as one; null for other events of hands. */
export function drivenEvent({event, at_s: time}) {
  if (!event.drive) return null;
  const {v, w} = event.drive;
  const detail = v === undefined ? 'by the route again' : `${v} m/s, ${w} rad/s`;
  return {time, kind: 'drive', detail, localizer: '', from: null, to: null};
}

/** The list, and the events themselves in `events`. */
export class LiveLog {
  constructor() {
    this.events = [];
    this.list = element('ol', {class: 'log', tabindex: 0, 'aria-label': 'What happened'});
  }

  add(event) {
    this.events.push(event);
    const words = [event.kind, event.detail && `(${event.detail})`, event.localizer].filter(Boolean).join(' ');
    this.list.prepend(element('li', {}, element('b', {}, clockText(event.time)), ` ${words}`));
    if (this.events.length <= kMost) return;
    this.events.shift();
    this.list.lastElementChild.remove();
  }

  /** What is later than `time` never happened. */
  cut(time) {
    while (this.events.length > 0 && this.events.at(-1).time > time + 1e-6) {
      this.events.pop();
      this.list.firstElementChild.remove();
    }
  }
}
