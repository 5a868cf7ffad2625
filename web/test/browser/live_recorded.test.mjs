// A recorded log on the page of a live run. CASTAWAY_CHROMIUM: the browser; CASTAWAY_PROGRAM: castaway.
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
const folder = mkdtempSync(join(tmpdir(), 'castaway-recorded-'));
let browser;
let page;
let live;

/** What castaway recorded in the lab: a CARMEN log and a map. */
function record() {
  execFileSync(kCastaway, ['run', '--duration', '40', '--set', 'events=[]', '--set', 'outputs={carmen: true, map: true, snapshots: false, report: false}',
    '--localizer', 'mh_amcl', '--out', join(folder, 'run')]);
  return {log: join(folder, 'run/log.carmen'), map: join(folder, 'run/map/map.yaml')};
}

before(async () => {
  const {log, map} = record();
  live = await startLive(kCastaway, [log, '--map', map, '--start', 'truth', '--localizer', 'mh_amcl', '--localizer', 'amcl']);
  browser = await Chromium.start(process.env.CASTAWAY_CHROMIUM);
  page = new LivePage(browser);
  await browser.open(live.url, {width: 1440, height: 900});
  await browser.until(`document.getElementById('castaway-live').dataset.ready === 'true'`);
});
after(async () => {
  await browser.close();
  live.server.kill('SIGTERM');
  rmSync(folder, {recursive: true});
});

test('a log is played, without the tools of a world', async () => {
  await page.playUntil(`${kTime} > 3`);
  const tools = await browser.evaluate(`[...document.querySelectorAll('.tools legend')].map((legend) => legend.textContent)`);
  assert.deepEqual(tools, ['Hands', 'Kidnap', 'Log', 'Localizer']);
  assert.equal(await browser.evaluate(`document.querySelectorAll('[data-tool]').length`), 2);
  assert.ok(await page.truth());
  assert.deepEqual(browser.errors, []);
});

test('the robot is dragged to where the log has been', async () => {
  const from = await page.truth();
  await page.playUntil(`${kTime} > 12`);
  const now = await page.truth();
  await browser.drag([await page.onScreen(now.x, now.y), await page.onScreen(from.x, from.y)]);
  await page.press('Step a scan');
  await page.press('Step a scan');
  await page.logged('the log goes on');
  await browser.until(`(({x, y}) => Math.hypot(x - ${from.x}, y - ${from.y}) < 0.3)(
    JSON.parse(document.getElementById('castaway-live').dataset.truth))`);
  if (process.env.CASTAWAY_SHOTS) writeFileSync(`${process.env.CASTAWAY_SHOTS}/recorded.png`, await browser.screenshot());
});

test('a place where the log has never been is refused with a line', async () => {
  const {x, y} = await page.truth();
  const corner = await browser.evaluate(`(({left, top}) => [left + 4, top + 4])(
    document.querySelector('canvas.map').getBoundingClientRect())`);
  await browser.drag([await page.onScreen(x, y), corner]);
  await page.noted('never within 2 m');
});

test('goes on from a scan, and back', async () => {
  await browser.evaluate(`document.querySelector('[aria-label="Scan of the log"]').value = '20'`);
  await page.press('Go on from this scan');
  await page.playUntil(`${kTime} > 14`);
  const kidnaps = `[...document.querySelectorAll('.log li')].filter((li) => li.textContent.includes('kidnap')).length`;
  assert.equal(await browser.evaluate(kidnaps), 2);
  await browser.evaluate(`(() => {
    const slider = document.querySelector('#castaway-live [aria-label="Time"]');
    slider.value = 8;
    slider.dispatchEvent(new Event('input'));
  })()`);
  await page.press('Go on from here');
  await browser.until(`${kTime} < 8.5 && ${kidnaps} === 0`);
  await page.press('To a look-alike');
  await page.playUntil(`${kTime} > 10`);
  assert.equal(await browser.evaluate(kidnaps), 1);
  assert.deepEqual(browser.errors, []);
});

test('what is saved is repeated by castaway replay', async () => {
  await page.press('Global localization');
  await page.playUntil(`${kTime} > 11`);
  const kidnap = await browser.evaluate(`[...document.querySelectorAll('.log li')].find((li) => li.textContent.includes('kidnap')).textContent`);
  const downloads = join(folder, 'downloads');
  await browser.send('Page.setDownloadBehavior', {behavior: 'allow', downloadPath: downloads});
  await page.press('Save as scenario');
  const file = join(downloads, 'replay-map-live.yaml');
  for (let tries = 0; tries < 200 && !existsSync(file); ++tries) await new Promise((resolve) => setTimeout(resolve, 50));
  execFileSync(kCastaway, ['replay', file, '--no-pictures', '--out', join(folder, 'again')]);
  const events = readFileSync(join(folder, 'again/events.csv'), 'utf8').split('\n');
  const spliced = events.filter((row) => row.includes('splice'));
  assert.equal(spliced.length, 1);
  assert.match(kidnap, new RegExp(Number(spliced[0].split(',')[0]).toFixed(1).replace('.', '\\.')));
  assert.equal(events.filter((row) => row.includes('relocalize')).length, 1);
});

test('another log is dropped on the page, and its report has an address', async () => {
  await page.choose({'walk.log': readFileSync(join(folder, 'run/log.carmen'), 'utf8').split('\n').slice(0, 900).join('\n')});
  await browser.until(`document.querySelector('.log').childElementCount === 0`);
  await page.playUntil(`${kTime} > 2`);
  await page.press('Report');
  await browser.until(`document.querySelector('#castaway-live .note a')`);
  const link = await browser.evaluate(`document.querySelector('#castaway-live .note a').href`);
  assert.match(await (await fetch(link)).text(), /castaway-player/);
  await page.choose({'broken.log': 'FLASER 3 1 2\n'});
  await page.noted('broken.log');
  assert.deepEqual(browser.errors, []);
});
