// What the page of a live run shows when it opens, and of faults. CASTAWAY_CHROMIUM: the browser; CASTAWAY_PROGRAM: castaway.
import assert from 'node:assert/strict';
import {after, before, test} from 'node:test';
import {Chromium} from './chromium.mjs';
import {kNow, kTime, LivePage} from './live_page.mjs';
import {startLive} from './live_program.mjs';

const kScans = `document.getElementById('castaway-live').view.recording.scans`;
let browser;
let page;
let live;

async function open() {
  await browser.open('about:blank');
  await browser.open(live.url, {width: 1366, height: 768});
  await browser.until(`document.getElementById('castaway-live').dataset.ready === 'true' && ${kScans} > 0
    && document.getElementById('castaway-live').dataset.truth`);
}

before(async () => {
  live = await startLive(process.env.CASTAWAY_PROGRAM, ['--localizer', 'mh_amcl', '--localizer', 'amcl', '--set', 'robot=mule', '--set', 'events=[]']);
  browser = await Chromium.start(process.env.CASTAWAY_CHROMIUM);
  page = new LivePage(browser);
  await open();
});
after(async () => {
  await browser.close();
  live.server.kill('SIGTERM');
});

const isShown = (selector) => browser.evaluate(`document.querySelector('${selector}')?.checkVisibility() ?? false`);
const faults = () => browser.evaluate(`document.querySelector('.faults').hidden ? '' : document.querySelector('.faults').textContent`);
const boxOf = (selector) => browser.evaluate(`(({left, top, right, bottom}) => ({left, top, right, bottom}))(
  document.querySelector('${selector}').getBoundingClientRect())`);

test('the robot and a scan are there before the run plays', async () => {
  assert.equal(await browser.evaluate(kScans), 1);
  assert.ok(await page.truth());
  assert.ok(await browser.evaluate(`document.getElementById('castaway-live').view.recording.details.length > 0`));
  assert.ok(await browser.evaluate(kNow) < 0.25);
  assert.equal(await browser.evaluate(`document.querySelector('#castaway-live > .transport .play').textContent`), 'Play');
});

test('a note says how the robot drives', async () => {
  assert.match(await browser.evaluate(`document.querySelector('.run-notes').textContent`), /^Note: the robot .*\.$/);
  assert.ok(await isShown('.run-notes'));
});

test('the map is as high as the controls beside it, and shows all of the world in it', async () => {
  const [map, tools] = [await boxOf('canvas.map'), await boxOf('.live-tools')];
  assert.ok(Math.abs(map.top - tools.top) < 2 && map.bottom >= tools.bottom - 2, JSON.stringify({map, tools}));
  const high = map.bottom - map.top;
  const [, top] = await page.onScreen(0, 5.6);
  const [, bottom] = await page.onScreen(0, -4.4);
  assert.ok(bottom - top > 0.9 * high && bottom - top < high, `${bottom - top} of ${high} px`);
});

test('the map, the curve and the time line are above the fold of 1366 x 768', async () => {
  for (const part of ['canvas.map', '.curve canvas', '#castaway-live .timeline']) {
    const {top, bottom} = await boxOf(part);
    assert.ok(top >= 0 && bottom > top + 60 && bottom <= 768, `${part}: ${top} to ${bottom}`);
  }
});

test('the large button plays the run by the keyboard, and is gone then', async () => {
  assert.ok(await isShown('.start'));
  await browser.evaluate(`document.querySelector('.start').focus()`);
  await browser.key('Enter');
  await browser.until(`${kNow} > 1`);
  assert.equal(await isShown('.start'), false);
  assert.equal(await browser.evaluate(`document.activeElement.textContent`), 'Pause');
  await page.pause();
  assert.equal(await isShown('.start'), false);
  await open();
  assert.equal(await isShown('.start'), false);
});

test('faults are named while they last, in the past, too', async () => {
  assert.equal(await faults(), '');
  await page.press('Break it');
  const broken = await browser.evaluate(kNow);
  await page.playUntil(`${kNow} > ${broken + 1}`);
  assert.equal(await faults(), 'Broken: lidar covered');
  await page.setSpeed(5);
  await page.playUntil(`${kNow} > ${broken + 7}`);
  await browser.until(`document.querySelector('.faults').hidden`);
  await page.look(broken + 2);
  await browser.until(`!document.querySelector('.faults').hidden && ${kTime} < ${broken + 3}`);
  await page.look(0.5);
  await browser.until(`document.querySelector('.faults').hidden && ${kTime} < 1`);
  assert.deepEqual(browser.errors, []);
});
