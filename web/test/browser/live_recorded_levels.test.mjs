// A bag on a 3-D map of two floors, on the page of a live run. CASTAWAY_CHROMIUM: the browser; CASTAWAY_PROGRAM: castaway.
import assert from 'node:assert/strict';
import {execFileSync} from 'node:child_process';
import {existsSync, mkdtempSync, readFileSync, rmSync, writeFileSync} from 'node:fs';
import {tmpdir} from 'node:os';
import {join} from 'node:path';
import {after, before, test} from 'node:test';
import {Chromium} from './chromium.mjs';
import {kTime, LivePage} from './live_page.mjs';
import {startLive} from './live_program.mjs';

const kCastaway = process.env.CASTAWAY_PROGRAM;
const kReady = `document.getElementById('castaway-live').dataset.ready === 'true'`;
const folder = mkdtempSync(join(tmpdir(), 'castaway-levels-'));
const saved = join(folder, 'downloads/replay-mezzanine-live.yaml');
let browser;
let page;
let live;

/** A bag of a robot that is put onto the mezzanine after 6 s, and the 3-D map. */
function record() {
  execFileSync(kCastaway, ['run', 'mezzanine/kidnaps', '--duration', '14', '--set', 'events=[{kidnap: {kind: teleport, at_s: 6, level: 1}}]',
    '--set', 'outputs={bag: true, snapshots: false, report: false}', '--out', join(folder, 'run')]);
  execFileSync(kCastaway, ['map', 'mezzanine', '--out', join(folder, 'mezzanine.map3d')]);
  return [join(folder, 'run/bag'), '--map3d', join(folder, 'mezzanine.map3d'), '--imu-topic', '/imu', '--start', 'truth'];
}

/** Chooses a floor below the map. */
function choose(level) {
  return browser.evaluate(`(() => {
    const floor = document.querySelector('select[aria-label="Floor shown"]');
    floor.value = '${level}';
    floor.dispatchEvent(new Event('change'));
    return [...floor.options].map((option) => option.textContent);
  })()`);
}

before(async () => {
  live = await startLive(kCastaway, record());
  browser = await Chromium.start(process.env.CASTAWAY_CHROMIUM);
  page = new LivePage(browser);
  await browser.open(live.url, {width: 1440, height: 900});
  await browser.until(kReady);
});
after(async () => {
  await browser.close();
  live.server.kill('SIGTERM');
  rmSync(folder, {recursive: true});
});

test('the floors of the 3-D map are shown', async () => {
  await page.playUntil(`${kTime} > 3`);
  const floors = await choose(-1);
  assert.equal(floors.length, 3);
  assert.match(floors[2], /^level 1: /);
  if (process.env.CASTAWAY_SHOTS) writeFileSync(`${process.env.CASTAWAY_SHOTS}/level-0.png`, await browser.screenshot());
  assert.deepEqual(browser.errors, []);
});

test('the robot is dragged to the floor that is chosen', async () => {
  const below = await page.truth();
  await page.playUntil(`${kTime} > 9`);
  if (process.env.CASTAWAY_SHOTS) writeFileSync(`${process.env.CASTAWAY_SHOTS}/level-1.png`, await browser.screenshot());
  const above = await page.truth();
  await choose(0);
  await browser.drag([await page.onScreen(above.x, above.y), await page.onScreen(below.x, below.y)]);
  await page.press('Step a scan');
  await page.press('Step a scan');
  await page.logged('the log goes on');
  await browser.until(`(({x, y}) => Math.hypot(x - ${below.x}, y - ${below.y}) < 0.3)(
    JSON.parse(document.getElementById('castaway-live').dataset.truth))`);
  assert.deepEqual(browser.errors, []);
});

test('what is saved is opened again', async () => {
  await browser.send('Page.setDownloadBehavior', {behavior: 'allow', downloadPath: join(folder, 'downloads')});
  await page.press('Save as scenario');
  for (let tries = 0; tries < 200 && !existsSync(saved); ++tries) await new Promise((resolve) => setTimeout(resolve, 50));
  execFileSync(kCastaway, ['replay', saved, '--no-pictures', '--out', join(folder, 'again')]);
  const [head, ...rows] = readFileSync(join(folder, 'again/events.csv'), 'utf8').trim().split('\n').map((row) => row.split(','));
  const splice = rows.find((row) => row.includes('splice'));
  assert.ok(Number(splice[head.indexOf('from_z_m')]) > 1);
  assert.ok(Math.abs(Number(splice[head.indexOf('to_z_m')])) < 0.1);
  const again = await startLive(kCastaway, [saved]);
  try {
    await browser.open(again.url, {width: 1440, height: 900});
    await browser.until(kReady);
    await page.play();
    await page.logged('the log goes on');
    assert.deepEqual(browser.errors, []);
  } finally {
    again.server.kill('SIGTERM');
  }
});
