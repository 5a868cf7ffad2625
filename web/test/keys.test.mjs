import assert from 'node:assert/strict';
import {test} from 'node:test';
import {actionOf, ownsKey} from '../src/keys.js';

test('keys ask for actions', () => {
  assert.deepEqual(actionOf({key: ' '}), ['toggle']);
  assert.deepEqual(actionOf({key: 'ArrowRight'}), ['step', 1]);
  assert.deepEqual(actionOf({key: 'ArrowLeft', shiftKey: true}), ['skip', -5]);
  assert.deepEqual(actionOf({key: 'Home'}), ['seek', -Infinity]);
  assert.deepEqual(actionOf({key: '+'}), ['zoom', 1.25]);
  assert.equal(actionOf({key: 'x'}), null);
});

test("the browser's own shortcuts stay its own", () => {
  assert.equal(actionOf({key: '+', ctrlKey: true}), null);
  assert.equal(actionOf({key: 'ArrowLeft', altKey: true}), null);
});

test('elements keep the keys that they need', () => {
  assert.ok(ownsKey({tagName: 'SELECT'}, 'ArrowUp'));
  assert.ok(ownsKey({tagName: 'BUTTON'}, ' '));
  assert.ok(ownsKey({tagName: 'INPUT', type: 'checkbox'}, ' '));
  assert.ok(!ownsKey({tagName: 'INPUT', type: 'range'}, 'ArrowLeft'));
  assert.ok(!ownsKey({tagName: 'CANVAS'}, ' '));
});
