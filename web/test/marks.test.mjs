import assert from 'node:assert/strict';
import {test} from 'node:test';
import {marksOf, sortOf, sortsOf, spread} from '../src/marks.js';

const events = [
  {time: 5, kind: 'recovery', detail: 'from kidnap', localizer: 'a'},
  {time: 3, kind: 'kidnap', detail: 'teleport', localizer: ''},
  {time: 4, kind: 'alarm on', detail: '', localizer: 'a'},
  {time: 6, kind: 'fault on', detail: 'blind', localizer: ''},
];

test('alarms are no marks', () => {
  assert.deepEqual(events.map(sortOf), ['recovery', 'kidnap', null, 'fault']);
});

test('marks come by time and say what they are', () => {
  const marks = marksOf(events);
  assert.deepEqual(marks.map((m) => m.label), ['kidnap: put, at 3.0 s',
    'a is right again after a kidnap, at 5.0 s', 'fault: blind, at 6.0 s']);
  assert.deepEqual(sortsOf(marks).map((s) => s.sort), ['kidnap', 'fault', 'recovery']);
});

test('of marks that would lie on each other the kidnap stays', () => {
  const marks = marksOf(events);
  assert.deepEqual(spread(marks, 0, 10, 100, 15).map((m) => m.sort), ['kidnap', 'fault']);
  assert.equal(spread(marks, 0, 10, 1000, 15).length, 3);
});
