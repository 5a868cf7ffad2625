// The layout for Foxglove: its panels are there once, and what they show is in a bag that castaway writes. CASTAWAY_PROGRAM: the program.
import assert from 'node:assert/strict';
import {execFileSync} from 'node:child_process';
import {mkdtempSync, readFileSync, rmSync} from 'node:fs';
import {tmpdir} from 'node:os';
import {join} from 'node:path';
import {after, test} from 'node:test';

const folder = mkdtempSync(join(tmpdir(), 'castaway-layout-'));
after(() => rmSync(folder, {recursive: true}));
const layout = JSON.parse(readFileSync(new URL('../../../foxglove/castaway.json', import.meta.url), 'utf8'));

function castaway(...words) {
  return execFileSync(process.env.CASTAWAY_PROGRAM, words, {encoding: 'utf8', maxBuffer: 1 << 30, stdio: 'pipe'});
}

function panelsOf(node) {
  return typeof node === 'string' ? [node] : [...panelsOf(node.first), ...panelsOf(node.second)];
}

/** Paths of messages that a panel shows: "/topic.field.list[0].field", or a topic alone. */
function pathsOf(panel) {
  const plotted = (panel.paths ?? []).map(({value}) => value);
  return [...plotted, ...Object.keys(panel.topics ?? {}), ...(panel.topicPath ? [panel.topicPath] : [])];
}

/** All values at a path in a message; [1:] stands for all elements from the second on. */
function valuesAt(message, fields) {
  return fields.reduce((values, field) => {
    const [, name, index] = field.match(/^(\w+)(?:\[(.+)\])?$/);
    const inner = values.map((value) => value[name]);
    if (index === undefined) return inner;
    return inner.flatMap((list) => (index.endsWith(':') ? list.slice(parseInt(index, 10)) : [list[parseInt(index, 10)]]));
  }, [message]);
}

test('every panel is placed once', () => {
  assert.deepEqual(panelsOf(layout.layout).sort(), Object.keys(layout.configById).sort());
});

test('what panels show is in a bag', () => {
  const run = join(folder, 'run');
  const sets = {
    'people.count': 3, 'events.0.kidnap.at_s': 1, 'outputs.snapshots': false, 'outputs.report': false, 'outputs.bag.particles': true,
  };
  castaway('run', '--duration', '4', '--seed', '5', '--out', run, ...Object.entries(sets).flatMap(([key, value]) => ['--set', `${key}=${value}`]));
  const topics = new Map();
  for (const line of castaway('bag', run, '--messages').trimEnd().split('\n')) {
    const {topic, message} = JSON.parse(line);
    topics.set(topic, [...(topics.get(topic) ?? []), message]);
  }
  const paths = Object.values(layout.configById).flatMap(pathsOf);
  assert.ok(paths.length > 15);
  for (const path of paths) {
    const [topic, ...fields] = path.split('.');
    assert.ok(topics.has(topic), `${topic} is in the bag`);
    if (fields.length === 0) continue;
    const values = topics.get(topic).flatMap((message) => valuesAt(message, fields));
    assert.ok(values.length > 0 && values.every((value) => typeof value === 'number'), `${path} has numbers`);
  }
});
