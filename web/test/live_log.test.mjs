import assert from 'node:assert/strict';
import {before, test} from 'node:test';
import {eventOf, LiveLog} from '../src/live_log.js';

const event = (time, kind = 'kidnap', more = {}) => ({time, kind, detail: 'teleport', localizer: '', from: null, to: [1, 2, 0.5], ...more});

/** As much of a document as a list takes. */
class Item {
  constructor() {
    this.children = [];
  }
  setAttribute() {}
  append(...added) {
    this.children.push(...added);
  }
  prepend(added) {
    added.remove = () => this.children.splice(this.children.indexOf(added), 1);
    this.children.unshift(added);
  }
  get firstElementChild() {
    return this.children[0];
  }
  get lastElementChild() {
    return this.children.at(-1);
  }
}

before(() => {
  globalThis.document = {createElement: () => new Item()};
});

test('places of events have no heading', () => {
  const given = event(3, 'kidnap', {from: [1, 2, 0.5], to: null});
  assert.deepEqual(eventOf(given), {...given, from: [1, 2]});
});

test('events that are told again take the place of what was there', () => {
  const log = new LiveLog();
  log.take(0, [event(1), event(2)]);
  log.take(2, [event(3), event(4)]);
  assert.deepEqual(log.events.map(({time}) => time), [1, 2, 3, 4]);
  const taken = log.take(1, [event(2), event(2.5)]);
  assert.deepEqual(taken.map(({number}) => number), [1, 2]);
  assert.deepEqual(log.events.map(({time}) => time), [1, 2, 2.5]);
  assert.deepEqual(log.list.children.map(({children}) => children[1]), Array(3).fill(' kidnap: put at 1, 2'));
  log.take(0, []);
  assert.deepEqual([log.events.length, log.list.children.length], [0, 0]);
});

test('the newest few hundred are kept', () => {
  const log = new LiveLog();
  log.take(0, Array.from({length: 700}, (_, i) => event(i)));
  assert.deepEqual([log.events.length, log.events[0].time, log.list.children.length], [500, 200, 500]);
  log.take(100, [event(100)]);
  assert.deepEqual(log.events.map(({number}) => number), [100]);
});
