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

let browser;
let server;
let url;

before(async () => {
  ({server, url} = await startLive(process.env.CASTAWAY_PROGRAM, ['--localizer', 'mh_amcl', '--localizer', 'amcl']));
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
