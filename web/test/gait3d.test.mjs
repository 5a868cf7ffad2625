import assert from 'node:assert/strict';
import {test} from 'node:test';
import {feetAhead, partsOf, peopleBetween, stepLength, Walks} from '../src/view3d/gait.js';
import {near} from './fixture.mjs';

const model = {body: [1.75, 0.07], bodies: [[1.75, 0.07], [1.92, 0.08]], torso_bottom: 0.5, head_height: 0.28, hip: 0.85,
  hip_side: 0.09, foot_side: 0.1};

test('a step at walking speed is as long as the simulator has it', () => {
  assert.ok(near([stepLength(1.34)], [Math.sqrt(0.0062 * 60 * 1.34)]));
});

test('a foot on the floor stays where it is while the body walks on', () => {
  const step = stepLength(1);
  const at = (walked) => walked + feetAhead(walked, 1)[0];
  assert.ok(near([at(0.1 * step), at(0.5 * step), at(0.9 * step)], Array(3).fill(at(0))));
  assert.ok(near([at(2 * step) - at(0)], [2 * step]));
});

test('feet are opposite each other, and beside each other when it stands', () => {
  const [left, right] = feetAhead(0.3, 1);
  assert.ok(near([left + right], [0]));
  assert.deepEqual(feetAhead(5, 0.05), [0, 0]);
});

test('people are between the scans, and carried on after the newest', () => {
  const before = [{id: 4, x: 0, y: 0, yaw: 0}];
  const after = [{id: 4, x: 0.1, y: 0, yaw: 0.2}, {id: 5, x: 7, y: 0, yaw: 0}];
  const [person, other] = peopleBetween(before, 1, after, 1.1, 1.05);
  assert.ok(near([person.x, person.yaw, person.speed], [0.05, 0.1, 1]));
  assert.deepEqual([other.x, other.speed], [7, 0]);
  assert.ok(near([peopleBetween(before, 1, after, 1.1, 1.2)[0].x], [0.2]));
  assert.ok(peopleBetween(before, 1, after, 1.1, 99)[0].x < 0.4, 'not for ever');
  assert.equal(peopleBetween(before, 1, [{...after[0], x: 9}], 1.1, 1.05)[0].x, 9, 'a jump is no walk');
  assert.equal(peopleBetween(after, 1, after, 1, 1)[0].x, 0.1, 'the first scan');
});

test('ways are counted, without jumps', () => {
  const walks = new Walks();
  const at = (x) => walks.add([{id: 0, x, y: 0}])[0].walked;
  const first = at(0);
  assert.ok(near([at(0.2) - first, at(0.5) - first, at(9) - first], [0.2, 0.5, 0.5]));
});

test('parts stand where the person does', () => {
  const parts = partsOf(model, {id: 0, x: 2, y: 3, yaw: Math.PI / 2, speed: 0, walked: 0});
  assert.ok(near(parts.feet.flat(), [1.9, 3, 2.1, 3]), 'the left foot is on the left');
  assert.ok(near(parts.hips.flat(), [1.91, 3, 0.85, 2.09, 3, 0.85]));
  assert.ok(near([parts.girth, ...parts.coat, parts.head], [1, 0, 1, 0]));
});

test('a tall person is tall up to the shoulders', () => {
  const {girth, coat: [base, stretch], head} = partsOf(model, {id: 1, x: 0, y: 0, yaw: 0, speed: 0, walked: 0});
  assert.ok(near([base + 0.5 * stretch, base + (1.75 - 0.28) * stretch], [0.5, 1.92 - 0.28]));
  assert.ok(near([girth, head], [8 / 7, 0.17]));
  assert.ok(near([partsOf(model, {id: 9, x: 0, y: 0, yaw: 0, speed: 0, walked: 0}).head], [0]), 'nothing is known of a later one');
});
