import assert from 'node:assert/strict';
import {afterEach, test} from 'node:test';
import {bring, mainFile, refusalOf} from '../src/live_files.js';

const file = (name, size = 10) => ({name, size});
const {fetch} = globalThis;
afterEach(() => {
  globalThis.fetch = fetch;
});

test('a world, a map or a robot is found among its files', () => {
  assert.deepEqual(mainFile(['wall.dae', 'House.SDF']), {file: 'House.SDF'});
  assert.deepEqual(mainFile(['map.pgm', 'map.yaml']), {file: 'map.yaml'});
  assert.deepEqual(mainFile(['base.stl', 'robot.urdf.xacro']), {file: 'robot.urdf.xacro'});
  assert.deepEqual(mainFile(['shop.world.xacro', 'map.yaml']), {file: 'shop.world.xacro'});
  assert.deepEqual(mainFile(['map.pgm', 'map.yaml', 'intel.log.gz']), {file: 'intel.log.gz', map: 'map.yaml'});
  assert.deepEqual(mainFile(['walk.mcap']), {file: 'walk.mcap', map: ''});
  assert.equal(mainFile(['map.pgm']), null);
});

test('files that are no use are refused before they are sent', () => {
  assert.equal(refusalOf([file('a.urdf')]), null);
  assert.match(refusalOf([file('a.pgm')]), /Drop a world/);
  assert.match(refusalOf([file('a.urdf'), file('big.dae', 65 * 2 ** 20)]), /big.dae/);
});

test('files are sent one by one, until one is refused', async () => {
  const sent = [];
  globalThis.fetch = async (target, {method}) => {
    sent.push(`${method} ${target}`);
    return {ok: !target.includes('bad'), text: async () => 'no\n'};
  };
  await bring([file('a b.urdf'), file('c.stl')], {search: '?token=t'});
  assert.deepEqual(sent, ['POST /file?token=t&name=a+b.urdf', 'POST /file?token=t&name=c.stl']);
  await assert.rejects(bring([file('bad.stl'), file('d.stl')], {search: '?token=t'}), /^Error: no$/);
  assert.equal(sent.length, 3);
});
