import assert from 'node:assert/strict';
import {test} from 'node:test';
import {Playback} from '../src/playback.js';

function playback() {
  const calls = {count: 0};
  return [new Playback([1, 2, 3, 4], () => ++calls.count), calls];
}

test('plays at its speed and stops at the end', () => {
  const [p] = playback();
  p.toggle();
  p.setSpeed(2);
  assert.equal(p.advance(0.5), true);
  assert.equal(p.time, 2);
  assert.equal(p.advance(10), false);
  assert.equal(p.time, 4);
  assert.equal(p.playing, false);
});

test('begins anew where it had ended', () => {
  const [p] = playback();
  p.seek(99);
  assert.equal(p.time, 4);
  p.toggle();
  assert.equal(p.time, 1);
});

test('stands still while it does not play', () => {
  const [p] = playback();
  assert.equal(p.advance(1), false);
  assert.equal(p.time, 1);
});

test('steps from scan to scan and no further', () => {
  const [p] = playback();
  p.seek(2.5);
  p.step(1);
  assert.equal(p.time, 3);
  p.step(-1);
  assert.equal(p.time, 2);
  p.step(-5);
  assert.equal(p.time, 1);
  p.step(9);
  assert.equal(p.time, 4);
});

test('jumps to events before and after', () => {
  const [p] = playback();
  p.jump([1.5, 3.5], 1);
  assert.equal(p.time, 1.5);
  p.jump([1.5, 3.5], 1);
  p.jump([1.5, 3.5], 1);
  assert.equal(p.time, 3.5);
  p.jump([1.5, 3.5], -1);
  assert.equal(p.time, 1.5);
});

test('speeds have a slowest and a fastest', () => {
  const [p] = playback();
  p.faster(1);
  assert.equal(p.speed, 2);
  p.faster(99);
  assert.equal(p.speed, 16);
  p.faster(-99);
  assert.equal(p.speed, 0.1);
});

test('tells of every change', () => {
  const [p, calls] = playback();
  p.seek(2);
  p.toggle();
  p.advance(0.1);
  p.pause();
  assert.equal(calls.count, 4);
});

test('does without scans', () => {
  const p = new Playback([], () => {});
  p.toggle();
  p.step(1);
  assert.equal(p.advance(1), false);
  assert.equal(p.time, 0);
});
