// The page of a live run, used as a reader would. CASTAWAY_CHROMIUM: the browser; CASTAWAY_PROGRAM: castaway.
import assert from 'node:assert/strict';
import {execFileSync} from 'node:child_process';
import {existsSync, mkdtempSync, readFileSync, rmSync, writeFileSync} from 'node:fs';
import {tmpdir} from 'node:os';
import {join} from 'node:path';
import {after as afterAll, before as beforeAll, test} from 'node:test';
import {Chromium} from './chromium.mjs';
import {kTime, LivePage} from './live_page.mjs';
import {startLive} from './live_program.mjs';
import {kPixels3d, kStill3d} from './pixels3d.mjs';

let browser;
let page;
let server;
let url;

beforeAll(async () => {
  ({server, url} = await startLive(process.env.CASTAWAY_PROGRAM, ['--localizer', 'mh_amcl', '--localizer', 'amcl',
    '--set', 'outputs.snapshots=false']));
  browser = await Chromium.start(process.env.CASTAWAY_CHROMIUM);
  page = new LivePage(browser);
  await browser.open(url);
  await browser.until(`document.getElementById('castaway-live').dataset.ready === 'true'`);
});
afterAll(async () => {
  await browser.close();
  server.kill('SIGTERM');
});

async function shot(name) {
  if (process.env.CASTAWAY_SHOTS) writeFileSync(`${process.env.CASTAWAY_SHOTS}/${name}.png`, await browser.screenshot());
}

test('plays, and reports no error', async () => {
  await page.play();
  await browser.until(`${kTime} > 2`);
  await shot('playing');
  assert.deepEqual(browser.errors, []);
});

/** Two places of the lab that nothing stands at. */
const kFree = [[6.5, -0.3], [0, 1.85]];
const freePlaceFarFrom = ({x, y}) => kFree.find(([px, py]) => Math.hypot(px - x, py - y) > 3);

test('the robot is dragged', async () => {
  await page.pause();
  const from = await page.truth();
  const goal = await freePlaceFarFrom(from);
  await browser.drag([await page.onScreen(from.x, from.y), await page.onScreen(2, 1), await page.onScreen(...goal)]);
  await page.play();
  await page.logged('kidnap');
  await browser.until(`(({x, y}) => Math.hypot(x - ${goal[0]}, y - ${goal[1]}) < 0.3)(
    JSON.parse(document.getElementById('castaway-live').dataset.truth))`);
  await shot('kidnapped');
});

test('kidnaps, faults and orders by buttons', async () => {
  await page.press('Spin the wheels');
  await page.logged('wheels turn');
  await page.press('Break it');
  await page.logged('lidar');
  await page.press('Global localization');
  await page.logged('global localization');
});

test('is driven by keys', async () => {
  await browser.send('Input.dispatchKeyEvent', {type: 'keyDown', key: 'a', code: 'KeyA', text: 'a'});
  await page.logged('drive');
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
/** Presses the button that is called so. */
const pressNamed = (name) => browser.evaluate(`document.querySelector('#castaway-live [aria-label="${name}"]').click()`);

test('the 3-D view shows world and robot, and that it moves', async () => {
  await page.pause();
  await browser.until(`document.querySelector('.view-choice')?.hidden === false`);
  await page.press('3-D');
  const first = await still3d();
  assert.ok(first.colors > 300, `${first.colors} colours`);
  await shot('view-3d');
  assert.deepEqual(await still3d(), first, 'nothing moves');
  await page.press('Step a scan');
  await browser.until(`(${kPixels3d}).sum !== ${first.sum}`);
  await showOnly('truth');
  await page.playUntil(`${kTime} > ${await browser.evaluate(kTime) + 4}`);  // No arc of a kidnap is left.
  const [alone, from] = [await still3d(), await page.truth()];
  await page.playUntil(`(({x, y}) => Math.hypot(x - ${from.x}, y - ${from.y}) > 0.3)(
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
  await page.press('3-D');
  const [before, from, count] = [await still3d(), await page.truth(), await browser.evaluate(`document.querySelector('.log').childElementCount`)];
  const [x, y] = await browser.evaluate(`(() => {
    const {left, top, width, height} = document.querySelector('canvas.view-3d').getBoundingClientRect();
    return [left + width / 2, top + height / 2];
  })()`);
  await browser.drag([[x, y], [x + 60, y + 20], [x + 90, y - 10]]);
  assert.notEqual((await still3d()).sum, before.sum);
  await browser.drag([[x, y]]);
  await page.press('Step a scan');
  await still3d();
  const to = await page.truth();
  assert.ok(Math.hypot(to.x - from.x, to.y - from.y) < 0.2);
  assert.equal(await browser.evaluate(`document.querySelector('.log').childElementCount`), count);
  await page.press('2-D');
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
  await page.press('3-D');
  await browser.until(`!document.querySelector('.note-3d').hidden`);
  assert.match(await browser.evaluate(`document.querySelector('.note-3d').textContent`), /WebGL/);
  assert.equal(await browser.evaluate(`getComputedStyle(document.querySelector('canvas.map')).visibility`), 'visible');
  assert.deepEqual(browser.errors, []);
  await browser.send('Page.removeScriptToEvaluateOnNewDocument', {identifier});
});

test('a page that is loaded again knows the past', async () => {
  await page.pause();
  const before = await browser.evaluate(kTime);
  await browser.open('about:blank');
  await browser.open(url);
  await browser.until(`${kTime} >= ${before} - 0.2`);
  const end = (name) => `Number(document.querySelector('[aria-label="Time"]').${name})`;
  await browser.until(`${end('max')} > 1.5 && ${end('min')} < 0.3`);
  await browser.until(`document.querySelector('.log').textContent.includes('wheels turn')`);
});

test('looks at the past, goes back, and on from there', async () => {
  await page.pause();
  const before = await browser.evaluate(kTime);
  await browser.evaluate(`(() => {
    const slider = document.querySelector('#castaway-live [aria-label="Time"]');
    slider.value = 1;
    slider.dispatchEvent(new Event('input'));
  })()`);
  await browser.until(`Math.abs(${kTime} - 1) < 0.11`);
  await shot('past');
  await page.press('Go on from here');
  await browser.until(`${kTime} < ${before} && ${kTime} >= 0.9 && document.querySelector('.log').childElementCount === 0`);
  await page.play();
  await browser.until(`${kTime} > 2`);
  assert.deepEqual(browser.errors, []);
});

test('boxes and people are put before the robot, and a box is taken away', async () => {
  await page.pause();
  await page.press('People ahead');
  await page.press('Box ahead');
  await page.play();
  await browser.until(`document.querySelector('.log').textContent.includes('box-')
    || !document.querySelector('#castaway-live .note').hidden`);  // There may be no room: then a line says so.
  await page.pause();
  const {x, y} = await page.truth();
  const free = freePlaceFarFrom({x, y});
  await page.press('Box');
  await browser.drag([await page.onScreen(...free), await page.onScreen(free[0], free[1] + 0.5)]);
  await browser.drag([await page.onScreen(...free), await page.onScreen(...free)]);  // There is one already.
  await page.play();
  await page.logged('placed');
  await shot('box');
  await page.pause();
  await page.press('Door, remove');
  await browser.drag([await page.onScreen(...free), await page.onScreen(...free)]);
  await page.play();
  await page.logged('taken away');
  await page.press('Teleport');
});

test('the saved scenario repeats the run', async () => {
  await page.press('Anywhere');
  await page.logged('kidnap');
  await page.pause();
  const folder = mkdtempSync(join(tmpdir(), 'castaway-live-'));
  await browser.send('Page.setDownloadBehavior', {behavior: 'allow', downloadPath: folder});
  await page.press('Save as scenario');
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

test('a world of one\'s own takes the place of the run, and its door opens', async () => {
  await page.choose({'note.txt': 'x'});
  await page.noted('Drop a world');
  await page.choose({'broken.yaml': 'objects: [3'});
  await page.noted('broken.yaml');
  await page.choose({'room.yaml': kRoom});
  const things = `document.querySelector('#castaway-live [aria-label="Doors and boxes"]')`;
  await browser.until(`${things}.value === 'gate'`);
  assert.equal(await browser.evaluate(`document.querySelector('h1').textContent`), 'room');
  await page.press('Open');
  await page.play();
  await page.logged('gate opened by 90°');
  await page.pause();
  await page.press('Close');
  await page.play();
  await page.logged('gate closed');
  await shot('own-world');
  await page.pause();
  assert.deepEqual(browser.errors, []);
});

test('a report of the run until now has its own address', async () => {
  await page.press('Report');
  await browser.until(`document.querySelector('#castaway-live .note a')`);
  const link = await browser.evaluate(`document.querySelector('#castaway-live .note a').href`);
  const report = await (await fetch(link)).text();
  assert.match(report, /castaway-player/);
  assert.equal((await fetch(link.replace(/token=.*/, 'token=x'))).status, 403);
});
