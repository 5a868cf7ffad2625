import assert from 'node:assert/strict';
import {test} from 'node:test';
import {facing, MapHand} from '../src/live_hands.js';

const view = {x: 0, y: 0, scale: 50, width: 400, height: 400};

function hand(tool, more = {}) {
  const sent = [];
  const state = {tool, holds: true, choices: {localizer: 'amcl'}, live: {truth: {x: 1, y: 1, yaw: 0.5}}, ...more};
  return {sent, hand: new MapHand(state, (event) => sent.push(event))};
}

test('the robot is dragged, and keeps its heading', () => {
  const {sent, hand: it} = hand('teleport');
  const grip = it.grab([1.1, 1], view);
  grip.move([2, 2]);
  assert.deepEqual(it.ghost, [2, 2, 0.5]);
  grip.drop([3.00049, 2]);
  assert.deepEqual(sent, [{kidnap: {kind: 'teleport', pose: [3, 2, 0.5]}}]);
  assert.equal(it.ghost, null);
});

test('beside the robot there is nothing to drag', () => {
  assert.equal(hand('carry').hand.grab([3, 3], view), null);
  assert.equal(hand(null).hand.grab([1, 1], view), null);
  assert.equal(hand('teleport', {holds: false}).hand.grab([1, 1], view), null);
  assert.equal(hand('teleport', {live: undefined}).hand.grab([1, 1], view), null);
});

test('an initial pose looks where the drag ends', () => {
  const {sent, hand: it} = hand('initial');
  it.grab([4, 0], view).drop([4, 2]);
  assert.deepEqual(sent, [{localizer: {name: 'amcl', do: 'initialize', pose: [4, 0, 1.571]}}]);
});

test('a short drag has no direction', () => {
  assert.deepEqual(facing([0, 0], [0.1, 0.1], 2), [0, 0, 2]);
  assert.deepEqual(facing([0, 0], [-1, 0], 2), [0, 0, Math.PI]);
});

test('a box is put where the pointer presses, and looks where the drag ends', () => {
  const {sent, hand: it} = hand('box');
  it.grab([4, 0], view).drop([4, 2]);
  assert.deepEqual(sent, [{box: {at: [4, 0], yaw_deg: 90, size: [0.6, 0.4, 0.6]}}]);
});

test('people come as they are chosen', () => {
  const {sent, hand: it} = hand('person', {choices: {people: {count: 3, walk: true}}});
  it.grab([4, 0], view).drop([3, 0]);
  assert.deepEqual(sent, [{people: {at: [4, 0], yaw_deg: 180, count: 3, walk: true}}]);
});

test('a touch turns a door or takes a box away', () => {
  const outline = [[0, 0], [1, 0], [1, 0.1], [0, 0.1]];
  const away = [[0, 0], [0, 1], [-0.1, 1], [-0.1, 0]];
  const things = new Map([
    ['D', {outline, closed: outline, door: true}], ['E', {outline: away, closed: outline, door: true}],
    ['A', {outline: outline.map(([x, y]) => [x + 3, y]), door: false}]]);
  const {sent, hand: it} = hand('thing', {things: () => things});
  it.grab([0.9, 0.2], view).drop();
  it.grab([-0.05, 0.9], view).drop();
  it.grab([3.5, 0.05], view).drop();
  assert.equal(it.grab([8, 8], view), null);
  assert.deepEqual(sent, [
    {door: {name: 'D', open_deg: 90}}, {door: {name: 'E', open_deg: 0}}, {remove: {name: 'A'}}]);
});

test('on several floors, the robot is put on the one that is seen', () => {
  const {sent, hand: it} = hand('carry', {seenLevel: () => 2});
  it.grab([1, 1], view).drop([3, 2]);
  assert.deepEqual(sent, [{kidnap: {kind: 'carry', pose: [3, 2, 0.5], level: 2}}]);
});
