// No page has a violation of axe-core's rules of impact moderate and above, wide and narrow, light and dark.
// CASTAWAY_CHROMIUM: the browser; CASTAWAY_PROGRAM: castaway; CASTAWAY_MODULES: folder of node_modules; CASTAWAY_REPORT: a
// run's page; CASTAWAY_PAGES: folder of the pages of experiments, comparisons and campaigns.
import assert from 'node:assert/strict';
import {resolve} from 'node:path';
import {after, before, test} from 'node:test';
import {pathToFileURL} from 'node:url';
import {axeSource, graveViolations} from './axe.mjs';
import {Chromium} from './chromium.mjs';
import {startLive} from './live_program.mjs';

const {env} = process;
const source = axeSource(env.CASTAWAY_MODULES);
const screens = [1440, 400].flatMap((width) => [false, true].map((dark) => ({width, height: 900, dark, mobile: width < 700})));
const nameOf = ({width, dark}) => `${width} px, ${dark ? 'dark' : 'light'}`;
const inPages = (path) => pathToFileURL(resolve(env.CASTAWAY_PAGES, path)).href;
const kTime = `Number(document.getElementById('castaway-live').dataset.time ?? 0)`;
let browser;
let live;

before(async () => {
  browser = await Chromium.start(env.CASTAWAY_CHROMIUM);
  live = await startLive(env.CASTAWAY_PROGRAM, ['--localizer', 'mh_amcl', '--localizer', 'amcl']);
});
after(async () => {
  await browser.close();
  live.server.kill('SIGTERM');
});

/** A live page with a past, an event, a refusal, and a moment that is looked at. */
async function openLive(screen) {
  await browser.open(live.url, screen);
  await browser.until(`document.getElementById('castaway-live').dataset.ready === 'true'`);
  const press = (text) => browser.evaluate(`[...document.querySelectorAll('#castaway-live button')]
    .find(({textContent}) => textContent === ${JSON.stringify(text)})?.click()`);
  await press('Take the hands');
  await press('Turn');
  await press('Play');
  await browser.until(`document.querySelector('.log li') && document.querySelector('.mark') && ${kTime} > 1`);
  await press('Pause');
  await browser.evaluate(`document.querySelector('[aria-label^="Duration"]').value = -1`);
  await press('Break it');
  await browser.until(`!document.querySelector('.note').hidden`);
  await browser.evaluate(`(() => {
    const slider = document.querySelector('.timeline input');
    slider.value = slider.min;
    slider.dispatchEvent(new Event('input'));
  })()`);
  await browser.until(`${kTime} < 0.5`);
}

/** A run's page at its first event. */
async function openReport(screen) {
  await browser.open(pathToFileURL(resolve(env.CASTAWAY_REPORT)).href, screen);
  await browser.until(`document.querySelector('#castaway-player[data-time]')`);
  await browser.evaluate(`(document.querySelector('.keys').open = true, document.querySelector('.mark')?.click())`);
}

const pages = {
  live: openLive,
  report: openReport,
  campaign: (screen) => browser.open(inPages('campaign/campaign.html'), screen),
  costs: (screen) => browser.open(inPages('campaign/costs.html'), screen),
  runs: (screen) => browser.open(inPages('before/index.html'), screen),
  plots: (screen) => browser.open(inPages('experiment/report.html'), screen),
  comparison: (screen) => browser.open(inPages('comparison/comparison.html'), screen),
};

for (const [name, open] of Object.entries(pages)) {
  for (const screen of screens) {
    test(`${name}, ${nameOf(screen)}`, async () => {
      await open(screen);
      assert.deepEqual(await graveViolations(browser, source), []);
    });
  }
}

test('a button without a name is found', async () => {
  await openReport(screens[0]);
  await browser.evaluate(`(() => {
    const button = document.querySelector('.transport button');
    for (const name of ['aria-label', 'title']) button.removeAttribute(name);
  })()`);
  const found = await graveViolations(browser, source);
  assert.equal(found.length, 1);
  assert.match(found[0], /^critical: button-name: /);
});
