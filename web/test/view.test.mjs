import assert from 'node:assert/strict';
import {test} from 'node:test';
import * as v from '../src/view.js';
import {near} from './fixture.mjs';

const view = v.fitted({left: 0, right: 10, bottom: 0, top: 5}, 424, 424);

test('a map fits in, with y up', () => {
  assert.ok(near([view.x, view.y, view.scale], [5, 2.5, 40]));
  assert.ok(near(v.toScreen(view, 0, 0), [12, 312]));
  assert.ok(near(v.toScreen(view, 10, 5), [412, 112]));
});

test('pixels lead back to the map', () => {
  assert.ok(near(v.toMap(view, ...v.toScreen(view, 1.25, -3)), [1.25, -3]));
});

test('zooming keeps the point under the finger', () => {
  const before = v.toMap(view, 100, 200);
  const closer = v.zoomed(view, 3, 100, 200);
  assert.ok(near(v.toMap(closer, 100, 200), before));
  assert.ok(near([closer.scale], [120]));
});

test('zooming ends somewhere', () => {
  assert.equal(v.zoomed(view, 1e9).scale, 2000);
  assert.equal(v.zoomed(view, 1e-9).scale, 2);
});

test('a hand moves the map along', () => {
  const point = v.toMap(view, 100, 100);
  assert.ok(near(v.toScreen(v.panned(view, 30, -20), ...point), [130, 80]));
});

test('another size keeps what is in the middle', () => {
  assert.ok(near(v.toMap(v.resized(view, 200, 100), 100, 50), v.toMap(view, 212, 212)));
});

test('the bounds of a turned map hold its corners', () => {
  const bounds = v.boundsOf({width: 4, height: 2, resolution_m: 0.5, origin: [1, 1, Math.PI / 2]});
  assert.ok(near([bounds.left, bounds.right, bounds.bottom, bounds.top], [0, 1, 1, 3]));
});

test('the scale bar is of a round length', () => {
  assert.equal(v.barLength(view), 2);
  assert.equal(v.barLength({...view, scale: 2}), 50);
  assert.equal(v.barLength({...view, scale: 600}), 0.1);
});
