// The page of a live run that went back holds what the report of the saved run holds. CASTAWAY_CHROMIUM: the browser;
// CASTAWAY_PROGRAM: castaway.
import assert from 'node:assert/strict';
import {execFileSync} from 'node:child_process';
import {mkdtempSync, rmSync} from 'node:fs';
import {tmpdir} from 'node:os';
import {join} from 'node:path';
import {after as afterAll, before as beforeAll, test} from 'node:test';
import {Chromium} from './chromium.mjs';
import {kNow, LivePage} from './live_page.mjs';
import {startLive} from './live_program.mjs';
import {assertSame, heldByPage, heldByReport, saveAndPlayAgain} from './live_report.mjs';

const kCastaway = process.env.CASTAWAY_PROGRAM;
const folder = mkdtempSync(join(tmpdir(), 'castaway-back-'));
const kTwo = ['--localizer', 'mh_amcl', '--localizer', 'amcl'];
let browser;
let page;
let live;

beforeAll(async () => {
  browser = await Chromium.start(process.env.CASTAWAY_CHROMIUM);
  page = new LivePage(browser);
});
afterAll(async () => {
  await browser.close();
  rmSync(folder, {recursive: true});
});

async function open(args) {
  live = await startLive(kCastaway, args);
  await browser.open(live.url, {width: 1366, height: 768});
  await browser.until(`document.getElementById('castaway-live').dataset.ready === 'true'`);
  await page.setSpeed(10);
}
async function end() {
  assert.deepEqual(browser.errors, []);
  await browser.open('about:blank');
  live.server.kill('SIGTERM');
}
const texts = () => browser.evaluate(`[...document.querySelectorAll('.log li')].map(({textContent}) => textContent)`);
const kidnaps = async () => (await texts()).filter((text) => text.includes('kidnap')).length;
const isPlaying = () => browser.evaluate(`document.querySelector('#castaway-live .play').textContent === 'Pause'`);
const now = () => browser.evaluate(kNow);

/** The page, as it is and loaded again, holds what the saved run has. */
async function assertTrue(name) {
  const report = heldByReport(await saveAndPlayAgain(page, kCastaway, folder, name));
  assertSame(await heldByPage(browser), report);
  await browser.open('about:blank');
  await browser.open(live.url, {width: 1366, height: 768});
  await browser.until(`document.getElementById('castaway-live').dataset.ready === 'true' && ${kNow} > 0`);
  assertSame(await heldByPage(browser), report);
}

/** A kidnap between two copies of the run, and a moment shortly after it to which it goes back from after the next copy. */
async function kidnapAndGoBack() {
  await page.playUntil(`${kNow} > 12.2`);
  await page.press('Anywhere');
  await page.playUntil(`document.querySelector('.log').textContent.includes('kidnap')`);
  const moment = await now() + 0.33;
  await page.playUntil(`${kNow} > 23`);
  await page.press('Anywhere');
  await page.playUntil(`${kNow} > 24`);
  assert.equal(await kidnaps(), 2);
  await page.goBack(moment);
  assert.equal(await kidnaps(), 1);
  assert.equal(await isPlaying(), false, 'it stood still, and does');
  return moment;
}

test('what is shown after going back is the run that is saved', async () => {
  await open([...kTwo, '--set', 'events=[]', '--set', 'people.count=2']);
  await kidnapAndGoBack();
  await page.playUntil(`${kNow} > 17`);
  await assertTrue('lab-kidnap-live.yaml');
});

test('going back again, and before what hands did, is told, too', async () => {
  await page.press('Break it');
  await page.press('Box ahead');
  await page.playUntil(`${kNow} > 19`);
  await page.goBack(18);
  await page.press('Spin the wheels');
  await page.playUntil(`${kNow} > 21`);
  await page.goBack(11.4);
  assert.deepEqual(await texts(), []);
  await page.press('Turn');
  await page.playUntil(`${kNow} > 13`);
  await page.goBack(4);  // Before the first copy that the run left on its way.
  await page.press('Turn');
  await page.playUntil(`${kNow} > 6`);
  assert.equal(await kidnaps(), 1);
  await assertTrue('lab-kidnap-live.yaml');
});

test('a run that plays goes on playing from there', async () => {
  await page.setSpeed(1);
  await page.play();
  const before = await now();
  await page.goBack(3);
  assert.equal(await isPlaying(), true);
  await browser.until(`${kNow} > 3.5 && ${kNow} < ${before}`);
  await page.pause();
  await end();
});

test('steps that the run made scan by scan are done again as they were', async () => {
  await open([...kTwo, '--set', 'events=[]']);
  await page.playUntil(`${kNow} > 9.3`);
  while (await now() < 10.5) await page.step();
  await page.press('Push');
  await page.step();
  await page.playUntil(`${kNow} > 12`);
  await page.goBack(11);
  assert.equal(await kidnaps(), 1);
  await page.playUntil(`${kNow} > 12`);
  await assertTrue('lab-kidnap-live.yaml');
  await end();
});

test('a program starts anew, and the page holds what it says then', async () => {
  await open(['--localizer', `program:${kCastaway} serve mh_amcl`, '--set', 'localizers.0.name=served', '--set', 'events=[]']);
  await kidnapAndGoBack();
  await page.playUntil(`${kNow} > 15`);
  await assertTrue('lab-kidnap-live.yaml');
  await end();
});

test('a recorded log goes back as a run does', async () => {
  const run = join(folder, 'recorded');
  execFileSync(kCastaway, ['run', '--duration', '60', '--set', 'events=[]', '--localizer', 'mh_amcl', '--out', run,
    '--set', 'outputs={carmen: true, map: true, snapshots: false, report: false}']);
  await open([join(run, 'log.carmen'), '--map', join(run, 'map/map.yaml'), '--start', 'truth', ...kTwo]);
  await kidnapAndGoBack();
  await page.press('Global localization');
  await page.playUntil(`${kNow} > 17`);
  await page.goBack(16);
  await page.playUntil(`${kNow} > 18`);
  await assertTrue('replay-map-live.yaml');
  await end();
});
