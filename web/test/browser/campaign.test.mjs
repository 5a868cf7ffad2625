// The page of a campaign, used as a reader would. CASTAWAY_CHROMIUM: the browser; CASTAWAY_PAGES: folder of the pages.
import assert from 'node:assert/strict';
import {join, resolve} from 'node:path';
import {after, before, beforeEach, test} from 'node:test';
import {pathToFileURL} from 'node:url';
import {Chromium} from './chromium.mjs';

let browser;

before(async () => {
  browser = await Chromium.start(process.env.CASTAWAY_CHROMIUM);
});
after(() => browser.close());
beforeEach(() => open(1280));

async function open(width) {
  browser.errors.length = 0;
  browser.requests.length = 0;
  const page = resolve(process.env.CASTAWAY_PAGES, join('campaign', 'campaign.html'));
  await browser.open(pathToFileURL(page).href, {width, height: 900, mobile: width < 700});
}

const kTexts = (name, column) => `[...document.querySelectorAll('[data-name="${name}"] tbody tr')]
  .filter((row) => !row.hidden).map((row) => row.cells[${column}].textContent)`;

function choose(selector, value) {
  return browser.evaluate(`(() => {
    const select = document.querySelector(${JSON.stringify(selector)});
    select.value = ${value};
    select.dispatchEvent(new Event('change'));
  })()`);
}

test('loads nothing and reports no error', async () => {
  assert.deepEqual(browser.requests.filter((url) => !/^(file|data|blob):/.test(url)), []);
  assert.deepEqual(browser.errors, []);
});

test('draws the figure that is chosen', async () => {
  const title = `document.querySelector('.campaign-curves figcaption').textContent`;
  assert.equal(await browser.evaluate(title), 'recovery.success over lidar.range_max');
  const index = await browser.evaluate(`[...document.querySelector('.campaign-curves select').options]
    .find(({textContent}) => textContent === 'tracking_error_m.mean').value`);
  await choose('.campaign-curves select', `"${index}"`);
  assert.equal(await browser.evaluate(title), 'tracking_error_m.mean over lidar.range_max');
  assert.equal(await browser.evaluate(`document.querySelectorAll('.campaign-curves canvas').length`), 1);
});

test('names units on the axes, and its specification', async () => {
  const labels = await browser.evaluate(`[...document.querySelectorAll('.campaign-curves .u-legend .u-label')]
    .map(({textContent}) => textContent)`);
  assert.deepEqual(labels, ['lidar.range_max [m]', 'mh_amcl', 'amcl']);
  const text = await browser.evaluate(`document.querySelector('.specification').innerText`);
  assert.match(text, /lidar\.range_max \[m\]\s+4, 12/);
  assert.match(text, /localizers\s+mh_amcl; amcl/);
});

test('draws survival curves by the values of a key', async () => {
  await choose('.campaign-recovery select', '"1"');
  const titles = await browser.evaluate(`[...document.querySelectorAll('.campaign-recovery figcaption')]
    .map(({textContent}) => textContent)`);
  assert.deepEqual(titles, ['lidar.range_max = 4', 'lidar.range_max = 12']);
});

test('sorts by numbers, and back', async () => {
  const sort = `document.querySelector('[data-name="worst"] th button').click()`;
  await browser.evaluate(sort);
  assert.deepEqual(await browser.evaluate(kTexts('worst', 0)), ['0', '1', '2', '3', '4', '5', '6', '7']);
  await browser.evaluate(sort);
  assert.deepEqual(await browser.evaluate(kTexts('worst', 0)), ['7', '6', '5', '4', '3', '2', '1', '0']);
});

test('sorts on a narrow screen, where no heads are shown', async () => {
  await choose('.order:has(option[value="11,1"])', '"0,-1"');
  assert.deepEqual(await browser.evaluate(kTexts('worst', 0)), ['7', '6', '5', '4', '3', '2', '1', '0']);
  const shown = `getComputedStyle(document.querySelector('.order')).display !== 'none'`;
  assert.equal(await browser.evaluate(shown), false);
  await open(400);
  assert.equal(await browser.evaluate(shown), true);
});

test('filters rows', async () => {
  await browser.evaluate(`(() => {
    const box = document.querySelector('[data-name="worst"]').closest('.wide').previousElementSibling;
    const input = box.querySelector('input');
    input.value = 'range_max = 12; localizers = mh_amcl';
    input.dispatchEvent(new Event('input'));
  })()`);
  assert.deepEqual((await browser.evaluate(kTexts('worst', 0))).sort(), ['4', '5']);
});

test('shows the layer and the colours that are chosen', async () => {
  const shown = `[...document.querySelectorAll('.heat')].map((layer) => getComputedStyle(layer).display !== 'none')`;
  const fill = `getComputedStyle([...document.querySelectorAll('.heat')].find((layer) =>
    getComputedStyle(layer).display !== 'none').querySelector('polygon')).fill`;
  assert.deepEqual(await browser.evaluate(shown), [true, false]);
  const none = await browser.evaluate(fill);
  await choose('.heat-series', '"1"');
  assert.deepEqual(await browser.evaluate(shown), [false, true]);
  assert.notEqual(await browser.evaluate(fill), none);  // `amcl` never recovers here.
  await choose('.heat-measure', '"n"');
  const legends = await browser.evaluate(`[...document.querySelectorAll('.heat-legend')]
    .filter((legend) => getComputedStyle(legend).display !== 'none').map(({innerText}) => innerText.slice(0, 8))`);
  assert.deepEqual(legends, ['Kidnaps:']);
});
