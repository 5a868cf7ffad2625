// Events of a run as marks on its time axes.
import {wordsOf} from './event_words.js';

const kSymbols = {kidnap: '▼', fault: '✕', collision: '✹', driving: '◆', operator: '●', recovery: '✓'};
const kColors = {kidnap: 'mark', fault: 'warn', collision: 'bad', driving: 'soft', operator: 'ink', recovery: 'good'};

/** What sort of mark an event is; null: it is none (alarms are stretches, not marks). */
export function sortOf(event) {
  if (event.kind.startsWith('fault')) return 'fault';
  return event.kind in kSymbols ? event.kind : null;
}

/** Events with `sort`, `symbol`, `color` (a name of the palette) and `label`, by time. */
export function marksOf(events) {
  return events.filter(sortOf).map((event) => {
    const sort = sortOf(event);
    return {...event, sort, symbol: kSymbols[sort], color: kColors[sort],
      label: `${wordsOf(event)}, at ${event.time.toFixed(1)} s`};
  }).sort((a, b) => a.time - b.time);
}

/** The sorts that occur, in a fixed order, with their symbols and colours. */
export function sortsOf(marks) {
  return Object.keys(kSymbols).filter((sort) => marks.some((mark) => mark.sort === sort))
    .map((sort) => ({sort, symbol: kSymbols[sort], color: kColors[sort]}));
}

/** Marks that a reader may jump to, without those that would lie on another: [px] apart. */
export function spread(marks, begin, end, width, apart) {
  const scale = width / Math.max(end - begin, 1e-9);
  const kept = [];
  const order = {kidnap: 0, collision: 1, fault: 2, driving: 3, operator: 4, recovery: 5};
  for (const mark of [...marks].sort((a, b) => order[a.sort] - order[b.sort] || a.time - b.time)) {
    if (kept.every((other) => Math.abs(other.time - mark.time) * scale >= apart)) kept.push(mark);
  }
  return kept.sort((a, b) => a.time - b.time);
}
