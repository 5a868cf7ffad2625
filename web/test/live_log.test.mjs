import assert from 'node:assert/strict';
import {test} from 'node:test';
import {drivenEvent, eventOf} from '../src/live_log.js';

test('places of events have no heading', () => {
  const event = {time: 3, kind: 'kidnap', detail: 'teleport', localizer: '', from: [1, 2, 0.5], to: null};
  assert.deepEqual(eventOf(event), {...event, from: [1, 2]});
});

test('a command to drive is listed like an event, other events of hands are not', () => {
  const driven = (drive) => drivenEvent({event: {drive}, at_s: 4});
  assert.deepEqual(driven({v: 0.2, w: -1}), {time: 4, kind: 'drive', detail: '0.2 m/s, -1 rad/s', localizer: '', from: null, to: null});
  assert.equal(driven({}).detail, 'by the route again');
  assert.equal(drivenEvent({event: {kidnap: {kind: 'turn'}}, at_s: 4}), null);
});
