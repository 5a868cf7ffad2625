import assert from 'node:assert/strict';
import {test} from 'node:test';
import * as c from '../src/view3d/camera.js';
import {near} from './fixture.mjs';

const south = {target: [1, 2, 0], azimuth: Math.PI / 2, elevation: Math.PI / 6, distance: 4};

test('a camera stands behind its target, as high as it looks down', () => {
  assert.ok(near(c.eyeOf(south), [1, 2 - 4 * Math.cos(Math.PI / 6), 2]));
});

test('the target is in the middle of the picture', () => {
  assert.ok(near(c.inPicture(south, south.target, 1.5), [0, 0]));
  assert.ok(near(c.inCamera(south, south.target), [0, 0, 4]));
});

test('east is right of north, what is high is up, what is behind is not seen', () => {
  const [right, up] = c.inPicture(south, [2, 2, 0], 1.5);
  assert.ok(right > 0.2 && Math.abs(up) < 1e-9);
  assert.ok(c.inPicture(south, [1, 2, 0.5], 1.5)[1] > 0.1);
  assert.ok(c.inPicture(south, [1, 3, 0], 1.5)[1] > 0.1, 'what is farther on the floor is higher');
  assert.equal(c.inPicture(south, [1, -9, 2], 1.5), null);
});

test('an edge of the picture is half of the field of view away', () => {
  const high = 4 * Math.tan((c.kFovDeg * Math.PI) / 360);
  const up = [0, Math.sin(Math.PI / 6), Math.cos(Math.PI / 6)];
  const point = south.target.map((value, i) => value + high * up[i]);
  assert.ok(near(c.inPicture(south, point, 2), [0, 1]));
  assert.ok(near([c.metresPerPixel(south, 100)], [high / 50]));
});

test('turning to the right goes clockwise, and never over the zenith or below the floor', () => {
  assert.ok(near([c.orbited(south, 0.1, 0).azimuth], [Math.PI / 2 - 0.1]));
  assert.ok(c.orbited(south, 0, 9).elevation < Math.PI / 2);
  assert.ok(c.orbited(south, 0, -9).elevation > 0);
  assert.ok(near(c.orbited(south, 0.3, 0.2).target, south.target));
});

test('a hand that drags keeps the floor under it', () => {
  const high = {...south, elevation: Math.PI / 2 - 1e-3};
  const moved = c.dragged(high, 30, 20, 400);
  const [x, y] = c.inPicture(moved, high.target, 1);
  assert.ok(near([200 * x, 200 * y], [30, -20], 0.1));
});

test('nearer has an end', () => {
  assert.ok(near([c.closer(south, 2).distance], [2]));
  assert.ok(c.closer(south, 1e9).distance >= 0.5);
  assert.ok(c.closer(south, 1e-9).distance <= 400);
});

for (const aspect of [0.5, 1, 2.4]) {
  test(`the whole world is in the picture, and fills it: ${aspect}`, () => {
    const extent = [-3, 1, 9, 6];
    for (const camera of [c.overview(extent, 2, aspect), c.fromAbove(extent, 2, aspect)]) {
      const places = c.cornersOf(extent, 2).map((point) => c.inPicture(camera, point, aspect));
      const largest = Math.max(...places.flat().map(Math.abs));
      assert.ok(largest <= 0.95 && largest > 0.9, `${largest}`);
    }
  });
}

test('follows from behind, and looks ahead of the robot', () => {
  const pose = {x: 2, y: 3, yaw: 0};
  const camera = c.following(c.kFollowing, pose);
  const [x, y, z] = c.eyeOf(camera);
  assert.ok(x < 0 && near([y], [3]) && z > 1, `${x} ${y} ${z}`);
  assert.ok(camera.target[0] > 2);
  assert.ok(near([c.following(c.kFollowing, {...pose, yaw: 1}).azimuth], [1]));
});

test('goes up where a wall is behind the robot, and stays before it', () => {
  const pose = {x: 0, y: 0, yaw: 0};
  const camera = c.following(c.kFollowing, pose, 1);
  const [x, , z] = c.eyeOf(camera);
  assert.ok(x >= -1 - 1e-9, `${x}`);
  assert.ok(z > c.eyeOf(c.following(c.kFollowing, pose))[2]);
});

test('a way between cameras ends, and takes the shorter turn', () => {
  const from = {...south, azimuth: 3.1};
  const goal = {...south, azimuth: -3.1, distance: 8};
  const middle = c.eased(from, goal, 0.5);
  assert.ok(Math.abs(Math.abs(middle.azimuth) - Math.PI) < 1e-9);
  assert.ok(near([middle.distance], [6]));
  let camera = from;
  let steps = 0;
  while (camera !== goal && steps < 1000) [camera, steps] = [c.eased(camera, goal, 0.3), steps + 1];
  assert.ok(steps > 3 && steps < 60, `${steps}`);
});
