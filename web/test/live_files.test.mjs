import assert from 'node:assert/strict';
import {afterEach, test} from 'node:test';
import {bring, mainFiles, refusalOf} from '../src/live_files.js';

const file = (name, size = 10) => ({name, file: {size}});
const {fetch} = globalThis;
afterEach(() => {
  globalThis.fetch = fetch;
});

test('a world, a map or a robot is found among its files', () => {
  const files = (...names) => mainFiles(names).map(({file: name}) => name);
  assert.deepEqual(files('wall.dae', 'House.SDF'), ['House.SDF']);
  assert.deepEqual(files('map.pgm', 'map.yaml'), ['map.yaml']);
  assert.deepEqual(files('base.stl', 'robot.urdf.xacro'), ['robot.urdf.xacro']);
  assert.deepEqual(files('shop.world.xacro', 'map.yaml'), ['shop.world.xacro']);
  assert.deepEqual(files('map.pgm'), []);
});

test('a log comes with its map', () => {
  assert.deepEqual(mainFiles(['map.pgm', 'map.yaml', 'intel.log.gz']), [{file: 'intel.log.gz', map: 'map.yaml'}]);
  assert.deepEqual(mainFiles(['walk.mcap']), [{file: 'walk.mcap', map: ''}]);
});

test('of a folder, what is no part of something else is loaded', () => {
  const files = (...names) => mainFiles(names).map(({file: name}) => name);
  assert.deepEqual(files('d/urdf/a.urdf', 'd/urdf/b.urdf', 'd/config/controllers.yaml', 'd/meshes/base.stl'), ['d/urdf/a.urdf', 'd/urdf/b.urdf']);
  assert.deepEqual(files('g/models/chair/model.sdf', 'g/models/desk/model-1_4.sdf', 'g/worlds/office.world'), ['g/worlds/office.world']);
  assert.deepEqual(files('g/urdf/a.urdf', 'g/worlds/b.world', 'g/map.yaml'), ['g/worlds/b.world', 'g/urdf/a.urdf']);
  assert.deepEqual(files('chair/model.sdf', 'chair/meshes/chair.dae'), ['chair/model.sdf']);
});

test('files that are no use are refused before they are sent', () => {
  assert.equal(refusalOf([file('a.urdf')]), null);
  assert.match(refusalOf([file('a.pgm')]), /Drop a world/);
  assert.match(refusalOf([file('a.urdf'), file('big.dae', 65 * 2 ** 20)]), /big.dae/);
  assert.match(refusalOf(Array.from({length: 2001}, () => file('a.urdf'))), /more than 2000 files/);
});

test('files are sent one by one, until one is refused', async () => {
  const sent = [];
  globalThis.fetch = async (target, {method}) => {
    sent.push(`${method} ${target}`);
    return {ok: !target.includes('bad'), text: async () => 'no\n'};
  };
  await bring([file('a b.urdf'), file('c.stl')], {search: '?token=t'});
  assert.deepEqual(sent, ['POST /file?token=t&name=a+b.urdf', 'POST /file?token=t&name=c.stl']);
  await assert.rejects(bring([file('bad.stl'), file('d.stl')], {search: '?token=t'}), /^Error: bad.stl: no$/);
  assert.equal(sent.length, 3);
});
