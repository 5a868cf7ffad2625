// The page of a live run, used as a reader would. CASTAWAY_CHROMIUM: the browser; CASTAWAY_PROGRAM: castaway.
import assert from 'node:assert/strict';
import {execFileSync} from 'node:child_process';
import {existsSync, mkdtempSync, readFileSync, rmSync, writeFileSync} from 'node:fs';
import {tmpdir} from 'node:os';
import {join} from 'node:path';
import {after, before, test} from 'node:test';
import {toScreen} from '../../src/view.js';
import {Chromium} from './chromium.mjs';
import {startLive} from './live_program.mjs';
import {kPixels3d, kStill3d} from './pixels3d.mjs';

let browser;
let server;
let url;

before(async () => {
  ({server, url} = await startLive(process.env.CASTAWAY_PROGRAM, ['--localizer', 'mh_amcl', '--localizer', 'amcl',
    '--set', 'outputs.snapshots=false']));
  browser = await Chromium.start(process.env.CASTAWAY_CHROMIUM);
  await browser.open(url);
  await browser.until(`document.getElementById('castaway-live').dataset.ready === 'true'`);
});
after(async () => {
  await browser.close();
  server.kill('SIGTERM');
});

const kTime = `Number(document.getElementById('castaway-live').dataset.time ?? 0)`;
/** Presses the button with this text, once there is one. */
async function press(text) {
  const button = `[...document.querySelectorAll('#castaway-live button')]
    .find((button) => button.textContent === ${JSON.stringify(text)})`;
  await browser.until(`${button} && !${button}.hidden`);
  await browser.evaluate(`${button}.click()`);
}

/** Until the run stands still. */
async function pause() {
  const text = "document.querySelector('#castaway-live .play').textContent";
  if (await browser.evaluate(text) === 'Pause') await press('Pause');
  await browser.until(`${text} === 'Play'`);
}

async function shot(name) {
  if (process.env.CASTAWAY_SHOTS) writeFileSync(`${process.env.CASTAWAY_SHOTS}/${name}.png`, await browser.screenshot());
}

test('plays, and reports no error', async () => {
  await press('Play');
  await browser.until(`${kTime} > 2`);
  await shot('playing');
  assert.deepEqual(browser.errors, []);
});

/** The point of the window where the map shows a point of the frame map, and where it shows the robot. */
async function onScreen(x, y) {
  const [left, top, view] = await browser.evaluate(`(() => {
    const box = document.querySelector('canvas.map').getBoundingClientRect();
    return [box.left, box.top, JSON.parse(document.getElementById('castaway-live').dataset.view)];
  })()`);
  const [px, py] = toScreen(view, x, y);
  return [left + px, top + py];
}
const truth = () => browser.evaluate(`JSON.parse(document.getElementById('castaway-live').dataset.truth)`);
const logged = (word) => browser.until(
  `[...document.querySelectorAll('.log li')].some((li) => li.textContent.includes(${JSON.stringify(word)}))`);

/** Two places of the lab that nothing stands at. */
const kFree = [[6.5, -0.3], [0, 1.85]];
const freePlaceFarFrom = ({x, y}) => kFree.find(([px, py]) => Math.hypot(px - x, py - y) > 3);

test('the robot is dragged', async () => {
  await pause();
  const from = await truth();
  const goal = await freePlaceFarFrom(from);
  await browser.drag([await onScreen(from.x, from.y), await onScreen(2, 1), await onScreen(...goal)]);
  await press('Play');
  await logged('kidnap');
  await browser.until(`(({x, y}) => Math.hypot(x - ${goal[0]}, y - ${goal[1]}) < 0.3)(
    JSON.parse(document.getElementById('castaway-live').dataset.truth))`);
  await shot('kidnapped');
});

test('kidnaps, faults and orders by buttons', async () => {
  await press('Spin the wheels');
  await logged('spin');
  await press('Break it');
  await logged('lidar');
  await press('Global localization');
  await logged('relocalize');
});

test('is driven by keys', async () => {
  await browser.send('Input.dispatchKeyEvent', {type: 'keyDown', key: 'a', code: 'KeyA', text: 'a'});
  await logged('drive');
  await browser.send('Input.dispatchKeyEvent', {type: 'keyUp', key: 'a', code: 'KeyA'});
});

const still3d = async () => {
  await browser.evaluate(kStill3d);
  return browser.evaluate(kPixels3d);
};
/** Shows these layers, and no others. */
const showOnly = (...layers) => browser.evaluate(`(() => {
  for (const label of document.querySelectorAll('.layers label')) {
    const box = label.querySelector('input');
    if (box.checked !== ${JSON.stringify(layers)}.includes(label.textContent)) box.click();
  }
})()`);
/** Until the run has played so far that this is true. */
async function playUntil(expression) {
  await press('Play');
  await browser.until(expression);
  await pause();
}
/** Presses the button that is called so. */
const pressNamed = (name) => browser.evaluate(`document.querySelector('#castaway-live [aria-label="${name}"]').click()`);

test('the 3-D view shows world and robot, and that it moves', async () => {
  await pause();
  await browser.until(`document.querySelector('.view-choice')?.hidden === false`);
  await press('3-D');
  const first = await still3d();
  assert.ok(first.colors > 300, `${first.colors} colours`);
  await shot('view-3d');
  assert.deepEqual(await still3d(), first, 'nothing moves');
  await press('Step a scan');
  await browser.until(`(${kPixels3d}).sum !== ${first.sum}`);
  await showOnly('truth');
  await playUntil(`${kTime} > ${await browser.evaluate(kTime) + 4}`);  // No arc of a kidnap is left.
  const [alone, from] = [await still3d(), await truth()];
  await playUntil(`(({x, y}) => Math.hypot(x - ${from.x}, y - ${from.y}) > 0.3)(
    JSON.parse(document.getElementById('castaway-live').dataset.truth))`);
  const moved = await still3d();
  assert.notEqual(moved.sum, alone.sum);
  await showOnly('estimates');
  assert.notEqual((await still3d()).sum, moved.sum);
  await showOnly('truth', 'estimates', 'particles', 'scan', 'people', 'last 12 s');
  assert.deepEqual(browser.errors, []);
});

test('cameras: follows, from above, turned by keys; the map comes back', async () => {
  const seen = [await still3d()];
  for (const name of ['Follow the robot (f)', 'From above (t)']) {
    await pressNamed(name);
    seen.push(await still3d());
  }
  await pressNamed('Whole map (0)');
  assert.deepEqual(await still3d(), seen[0], 'as it was at first');
  await pressNamed('Closer (+)');
  seen.push(await still3d());
  await browser.evaluate(`document.querySelector('canvas.view-3d').focus()`);
  await browser.key('ArrowLeft');
  seen.push(await still3d());
  assert.equal(new Set(seen.map(({sum}) => sum)).size, seen.length);
  assert.equal(await browser.evaluate(`getComputedStyle(document.querySelector('canvas.map')).visibility`), 'hidden');
  await browser.key('3');
  await browser.until(`document.querySelector('canvas.view-3d').hidden`);
  assert.equal(await browser.evaluate(`getComputedStyle(document.querySelector('canvas.map')).visibility`), 'visible');
  assert.deepEqual(browser.errors, []);
});

test('a pointer in the 3-D view turns it, and does nothing to the robot', async () => {
  await press('3-D');
  const [before, from, count] = [await still3d(), await truth(), await browser.evaluate(`document.querySelector('.log').childElementCount`)];
  const [x, y] = await browser.evaluate(`(() => {
    const {left, top, width, height} = document.querySelector('canvas.view-3d').getBoundingClientRect();
    return [left + width / 2, top + height / 2];
  })()`);
  await browser.drag([[x, y], [x + 60, y + 20], [x + 90, y - 10]]);
  assert.notEqual((await still3d()).sum, before.sum);
  await browser.drag([[x, y]]);
  await press('Step a scan');
  await still3d();
  const to = await truth();
  assert.ok(Math.hypot(to.x - from.x, to.y - from.y) < 0.2);
  assert.equal(await browser.evaluate(`document.querySelector('.log').childElementCount`), count);
  await press('2-D');
});

test('without WebGL one line says so, and the map goes on', async () => {
  const {identifier} = await browser.send('Page.addScriptToEvaluateOnNewDocument', {source: `{
    const {getContext} = HTMLCanvasElement.prototype;
    HTMLCanvasElement.prototype.getContext = function(kind, more) {
      return kind.startsWith('webgl') ? null : getContext.call(this, kind, more);
    };
  }`});
  await browser.open('about:blank');
  await browser.open(url);
  await browser.until(`document.querySelector('.view-choice')?.hidden === false`);
  await press('3-D');
  await browser.until(`!document.querySelector('.note-3d').hidden`);
  assert.match(await browser.evaluate(`document.querySelector('.note-3d').textContent`), /WebGL/);
  assert.equal(await browser.evaluate(`getComputedStyle(document.querySelector('canvas.map')).visibility`), 'visible');
  assert.deepEqual(browser.errors, []);
  await browser.send('Page.removeScriptToEvaluateOnNewDocument', {identifier});
});

test('a page that is loaded again knows the past', async () => {
  await pause();
  const before = await browser.evaluate(kTime);
  await browser.open('about:blank');
  await browser.open(url);
  await browser.until(`${kTime} >= ${before} - 0.2`);
  const end = (name) => `Number(document.querySelector('[aria-label="Time"]').${name})`;
  await browser.until(`${end('max')} > 1.5 && ${end('min')} < 0.3`);
  await browser.until(`document.querySelector('.log').textContent.includes('spin')`);
});

test('looks at the past, goes back, and on from there', async () => {
  await pause();
  const before = await browser.evaluate(kTime);
  await browser.evaluate(`(() => {
    const slider = document.querySelector('#castaway-live [aria-label="Time"]');
    slider.value = 1;
    slider.dispatchEvent(new Event('input'));
  })()`);
  await browser.until(`Math.abs(${kTime} - 1) < 0.11`);
  await shot('past');
  await press('Go on from here');
  await browser.until(`${kTime} < ${before} && ${kTime} >= 0.9 && document.querySelector('.log').childElementCount === 0`);
  await press('Play');
  await browser.until(`${kTime} > 2`);
  assert.deepEqual(browser.errors, []);
});

test('boxes and people are put before the robot, and a box is taken away', async () => {
  await pause();
  await press('People ahead');
  await press('Box ahead');
  await press('Play');
  await browser.until(`document.querySelector('.log').textContent.includes('box-')
    || !document.querySelector('#castaway-live .note').hidden`);  // There may be no room: then a line says so.
  await pause();
  const {x, y} = await truth();
  const free = freePlaceFarFrom({x, y});
  await press('Box');
  await browser.drag([await onScreen(...free), await onScreen(free[0], free[1] + 0.5)]);
  await browser.drag([await onScreen(...free), await onScreen(...free)]);  // There is one already.
  await press('Play');
  await logged('put');
  await shot('box');
  await pause();
  await press('Door, remove');
  await browser.drag([await onScreen(...free), await onScreen(...free)]);
  await press('Play');
  await logged('taken away');
  await press('Teleport');
});

test('the saved scenario repeats the run', async () => {
  await press('Anywhere');
  await logged('kidnap');
  await pause();
  const folder = mkdtempSync(join(tmpdir(), 'castaway-live-'));
  await browser.send('Page.setDownloadBehavior', {behavior: 'allow', downloadPath: folder});
  await press('Save as scenario');
  const file = join(folder, 'lab-kidnap-live.yaml');
  for (let tries = 0; tries < 200 && !existsSync(file); ++tries) await new Promise((resolve) => setTimeout(resolve, 50));
  execFileSync(process.env.CASTAWAY_PROGRAM, ['run', file, '--set', 'outputs.snapshots=false', '--out', join(folder, 'run')]);
  const shown = await browser.evaluate(`[...document.querySelectorAll('.log li')]
    .filter((li) => li.textContent.includes('kidnap')).length`);
  const events = readFileSync(join(folder, 'run/events.csv'), 'utf8').split('\n').filter((row) => row.includes('kidnap'));
  assert.equal(events.length, shown);
  rmSync(folder, {recursive: true});
});

const kRoom = `name: room
extent: {min: [-3, -3], max: [3, 3]}
objects:
  - wall: {name: outer, closed: true, points: [[-3, -3], [3, -3], [3, 3], [-3, 3]]}
  - wall: {name: west, points: [[-3, 0], [-0.5, 0]]}
  - wall: {name: east, points: [[0.5, 0], [3, 0]]}
  - door: {name: gate, at: [0, 0], width: 1}
`;

/** Chooses files by the page's button. */
const choose = (name, text) => browser.evaluate(`(() => {
  const files = new DataTransfer();
  files.items.add(new File([${JSON.stringify(text)}], ${JSON.stringify(name)}));
  const input = document.querySelector('#castaway-live input[type=file]');
  input.files = files.files;
  input.dispatchEvent(new Event('change'));
})()`);
const noted = (word) => browser.until(
  `document.querySelector('#castaway-live .note').textContent.includes(${JSON.stringify(word)})`);

test('a world of one\'s own takes the place of the run, and its door opens', async () => {
  await choose('note.txt', 'x');
  await noted('Drop a world');
  await choose('broken.yaml', 'objects: [3');
  await noted('broken.yaml');
  await choose('room.yaml', kRoom);
  const things = `document.querySelector('#castaway-live [aria-label="Doors and boxes"]')`;
  await browser.until(`${things}.value === 'gate'`);
  assert.equal(await browser.evaluate(`document.querySelector('h1').textContent`), 'room');
  await press('Open');
  await press('Play');
  await logged('gate open by 90 deg');
  await pause();
  await press('Close');
  await press('Play');
  await logged('gate closed');
  await shot('own-world');
  await pause();
  assert.deepEqual(browser.errors, []);
});

test('a report of the run until now has its own address', async () => {
  await press('Report');
  await browser.until(`document.querySelector('#castaway-live .note a')`);
  const link = await browser.evaluate(`document.querySelector('#castaway-live .note a').href`);
  const report = await (await fetch(link)).text();
  assert.match(report, /castaway-player/);
  assert.equal((await fetch(link.replace(/token=.*/, 'token=x'))).status, 403);
});
