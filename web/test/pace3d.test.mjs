import assert from 'node:assert/strict';
import {test} from 'node:test';
import {Pace} from '../src/view3d/pace.js';

/** The scale after `count` pictures, `way` [ms] apart. */
function after(pace, count, way, begin = 0) {
  let scale;
  for (let i = 0; i < count; ++i) scale = pace.add(begin + i * way);
  return scale;
}

test('thirty pictures a second are fast enough', () => {
  assert.equal(after(new Pace(), 500, 33), 1);
});

test('slow pictures become coarser, not at once, and up to an end', () => {
  const pace = new Pace();
  assert.equal(after(pace, 8, 60), 1);
  const coarser = after(pace, 20, 60, 8 * 60);
  assert.ok(coarser < 1);
  assert.equal(after(pace, 500, 60, 28 * 60), 0.6);
});

test('finer pictures are tried again, ever more rarely where they fail', () => {
  const pace = new Pace();
  let now = 0;
  const changes = [];
  for (let i = 0, last = 1; i < 3000; ++i) {
    now += pace.scale > 0.9 ? 60 : 30;  // Only coarser ones are fast enough.
    const scale = pace.add(now);
    if (scale > last) changes.push(i);
    last = scale;
  }
  assert.ok(changes.length >= 3 && changes.length < 9, `${changes}`);
  const waits = changes.slice(1).map((at, i) => at - changes[i]);
  assert.ok(waits.every((wait, i) => i === 0 || wait > 1.5 * waits[i - 1]), `${waits}`);
});

test('a picture a second means that nothing moves', () => {
  assert.equal(after(new Pace(), 100, 1000), 1);
});

test('who rests sees all pixels again', () => {
  const pace = new Pace();
  after(pace, 100, 60);
  pace.rest();
  assert.equal(pace.add(1e6), 1);
});
