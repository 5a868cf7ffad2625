// A node of ROS 2 as a localizer of a live run. CASTAWAY_CHROMIUM: the browser; CASTAWAY_PROGRAM: castaway;
// CASTAWAY_PEER: the node.
import assert from 'node:assert/strict';
import {spawn} from 'node:child_process';
import {after, before, test} from 'node:test';
import {Chromium} from './chromium.mjs';
import {kTime, LivePage} from './live_page.mjs';
import {startLive} from './live_program.mjs';

const kDomain = '100';
let browser;
let page;
let live;
let node;

before(async () => {
  node = spawn(process.env.CASTAWAY_PEER, ['--domain', kDomain, '--patience', '30', '--stay']);
  live = await startLive(process.env.CASTAWAY_PROGRAM, ['--localizer', `ros2:${kDomain}`, '--set', 'events=[]']);
  browser = await Chromium.start(process.env.CASTAWAY_CHROMIUM);
  page = new LivePage(browser);
  await browser.open(live.url, {width: 1440, height: 900});
  await browser.until(`document.getElementById('castaway-live').dataset.ready === 'true'`);
});
after(async () => {
  await browser.close();
  live.server.kill('SIGTERM');
  node.kill('SIGTERM');
});

const states = () => browser.evaluate(`[...document.querySelectorAll('.card .state')].map(({textContent}) => textContent)`);

test('it answers', async () => {
  await page.playUntil(`${kTime} > 4`);
  assert.deepEqual(await states(), ['right']);
});

test('the run goes back, and the node is told the start again', async () => {
  await page.press('Anywhere');
  await page.playUntil(`${kTime} > 6`);
  await page.goBack(2);
  await page.playUntil(`${kTime} > 4`);
  assert.deepEqual(await states(), ['right']);
});

test('its domain is taken for a report and for another world', async () => {
  await page.press('Report');
  await page.noted('someone else publishes /clock');
  await page.choose({'room.yaml': 'name: room\nextent: {min: [-3, -3], max: [3, 3]}\nobjects: []\n'});
  await page.noted('a node of ROS 2 loads nothing else');
  assert.deepEqual(browser.errors, []);
});
