import assert from 'node:assert/strict';
import {test} from 'node:test';
import * as measures from '../src/measures.js';
import {Recording} from '../src/recording.js';
import {fixture, near} from './fixture.mjs';

test('angles are taken the short way round', () => {
  assert.ok(near([0, 3, -3, 4, -4, 7].map(measures.wrapped),
    [0, 3, -3, 4 - 2 * Math.PI, 2 * Math.PI - 4, 7 - 2 * Math.PI]));
});

test('errors are those of the poses, none of a torn scan', () => {
  const recording = new Recording(fixture());
  const {position, yaw} = measures.errorsOf(recording, recording.localizers[0]);
  assert.equal(position[1], null);
  assert.ok(near([position[0], yaw[0]], [0.2, 0.1]));
});

test('truth is known, or it is not', () => {
  assert.equal(measures.hasTruth({truth: {known: [0, 1, 0]}}), true);
  assert.equal(measures.hasTruth({truth: {known: new Uint8Array(3)}}), false);
  assert.equal(measures.hasTruth({truth: {known: []}}), true);  // Of a live run that begins.
});

test('states tell right from wrong and from lost', () => {
  const localizer = {lost: [0, 0, 1, 1, 0, 0, 1]};
  const errors = {position: [0.1, 0.6, 0.6, 0.1, 0.1, null, null], yaw: [0, 0, 0, 0, 1, null, null]};
  assert.deepEqual(measures.statesOf(localizer, errors, 0.5, 0.35), [
    measures.kRight, measures.kWrong, measures.kSaysLost, measures.kFalseAlarm, measures.kWrong,
    measures.kUnknown, measures.kSaysLost]);
});

test('stretches follow one another without gaps', () => {
  assert.deepEqual(measures.stretches([0, 0, 4, 4, 0], [0, 1, 2, 3, 4], 5), [
    {state: 0, from: 0, to: 2}, {state: 4, from: 2, to: 4}, {state: 0, from: 4, to: 5}]);
  assert.deepEqual(measures.stretches([], [], 5), []);
});
