// Pages of an experiment, a comparison, a run, several runs and a campaign at the widths of a wide screen and of a telephone, light and dark.
// CASTAWAY_CHROMIUM: the browser; CASTAWAY_PAGES: folder of the pages; CASTAWAY_SCREENSHOTS: folder that pictures are
// left in (optional).
import assert from 'node:assert/strict';
import {mkdirSync, writeFileSync} from 'node:fs';
import {join, resolve} from 'node:path';
import {after, before, test} from 'node:test';
import {pathToFileURL} from 'node:url';
import {Chromium} from './chromium.mjs';

const pages = {
  experiment: 'experiment/report.html', comparison: 'comparison/comparison.html', run: 'before/seed-1/report.html',
  runs: 'before/index.html', campaign: 'campaign/campaign.html', costs: 'campaign/costs.html',
};
const folder = process.env.CASTAWAY_SCREENSHOTS;
let browser;

before(async () => {
  browser = await Chromium.start(process.env.CASTAWAY_CHROMIUM);
});
after(() => browser.close());

async function open(name, width, dark) {
  browser.errors.length = 0;
  const url = pathToFileURL(resolve(process.env.CASTAWAY_PAGES, pages[name])).href;
  await browser.open(url, {width, height: 900, dark, mobile: width < 700});
  if (!folder) return;
  mkdirSync(folder, {recursive: true});
  writeFileSync(join(folder, `${name}-${width}-${dark ? 'dark' : 'light'}.png`), await browser.screenshot(true));
}

/** The tables of which a part lies beyond the window or beyond what they may scroll in. */
const kCut = `[...document.querySelectorAll('table')].filter((table) => {
  const box = table.closest('.wide') ?? table.parentElement;
  return table.getBoundingClientRect().right > innerWidth + 1 || box.scrollWidth > box.clientWidth + 1;
}).map((table) => table.innerText.slice(0, 80))`;

for (const name of Object.keys(pages)) {
  for (const width of [1600, 400]) {
    for (const dark of [false, true]) {
      test(`cuts off nothing: ${name}, ${width} px, ${dark ? 'dark' : 'light'}`, async () => {
        await open(name, width, dark);
        assert.ok(await browser.evaluate('document.querySelectorAll("table").length') > 0);
        assert.ok(await browser.evaluate('document.documentElement.scrollWidth <= innerWidth'), 'too wide');
        assert.deepEqual(await browser.evaluate(kCut), []);
        assert.deepEqual(browser.errors, []);
      });
    }
  }
}

/** Of every plot: its name, its series, the number of colours on its canvas, whether it fits into the window. */
const kPlots = `[...document.querySelectorAll('.plots .uplot')].map((plot) => {
  const canvas = plot.querySelector('canvas');
  const {data} = canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height);
  const drawn = new Set();
  for (let i = 0; i < data.length; i += 4) {
    if (data[i + 3] > 60) drawn.add(data[i] << 16 | data[i + 1] << 8 | data[i + 2]);
  }
  const names = [...plot.querySelectorAll('.u-legend .u-series .u-label')].map((label) => label.textContent);
  const box = plot.getBoundingClientRect();
  const fits = box.left >= 0 && box.right <= innerWidth + 1;
  return {name: canvas.getAttribute('aria-label'), names, colors: drawn.size, fits};
})`;

for (const width of [1600, 400]) {
  for (const dark of [false, true]) {
    test(`draws every plot of experiment 2 within the window: ${width} px, ${dark ? 'dark' : 'light'}`, async () => {
      await open('experiment', width, dark);
      const plots = await browser.evaluate(kPlots);
      assert.equal(await browser.evaluate('document.querySelectorAll(".plots figure").length'), 4 + 2 + 4);
      assert.ok(plots.length >= 4 + 2 + 2);  // The ROC curve of a localizer that is never wrong is a sentence.
      for (const {name, names, colors, fits} of plots) {
        assert.ok(fits, `${name} is too wide`);
        assert.ok(colors > 8, `${name} is empty`);
        assert.ok(names.length >= 4, name);  // x and three or four series
        assert.match(name, /: .*, /);
      }
    });
  }
}

test('reads the column of each cell on a telephone', async () => {
  await open('comparison', 400, false);
  const head = await browser.evaluate(`getComputedStyle(document.querySelector('td[data-head]'), '::before').content`);
  assert.equal(head, '"pairs"');
});

test('draws intervals of a comparison without dashes', async () => {
  await open('comparison', 1600, false);
  const dashes = await browser.evaluate(`[...document.querySelectorAll('.bar')].map((bar) =>
    getComputedStyle(bar).strokeDasharray)`);
  assert.ok(dashes.length > 0 && dashes.every((dash) => dash === 'none'));
});

const kSeeds = `[...document.querySelectorAll('[data-name="runs"] tbody tr')].filter((row) => !row.hidden)
  .map((row) => row.cells[0].textContent)`;

test('the page of several runs begins with what they amount to, and sorts and reduces its table of runs', async () => {
  await open('runs', 1600, false);
  assert.deepEqual(await browser.evaluate(`[...document.querySelectorAll('h2')].map(({textContent}) => textContent)`),
    ['Result', 'Recoveries', 'Runs']);
  assert.equal(await browser.evaluate(`document.querySelectorAll('svg.chart path').length`), 2);  // A line a localizer.
  const sort = `document.querySelector('[data-name="runs"] th button').click()`;
  const state = `document.querySelector('[data-name="runs"] th').getAttribute('aria-sort')`;
  await browser.evaluate(sort);
  assert.deepEqual([await browser.evaluate(state), await browser.evaluate(kSeeds)], ['ascending', ['seed 1', 'seed 2']]);
  await browser.evaluate(sort);
  assert.deepEqual([await browser.evaluate(state), await browser.evaluate(kSeeds)], ['descending', ['seed 2', 'seed 1']]);
  const failed = await browser.evaluate(`[...document.querySelectorAll('[data-name="runs"] tbody tr')]
    .filter((row) => row.querySelector('.bad')).length`);
  assert.ok(failed > 0);  // `amcl` does not recover here.
  await browser.evaluate(`document.querySelector('.table-tools input[type="checkbox"]').click()`);
  assert.equal((await browser.evaluate(kSeeds)).length, failed);
});

test('one localizer has one colour in the chart of several runs and in the report of one', async () => {
  const lineOf = (name) => `[...document.querySelectorAll('.legend span, th')]
    .find((it) => it.textContent.startsWith('${name}') && it.querySelector('line')).querySelector('line').getAttribute('class')`;
  await open('runs', 1600, false);
  const there = [await browser.evaluate(lineOf('mh_amcl')), await browser.evaluate(lineOf('amcl'))];
  await open('run', 1600, false);
  assert.deepEqual([await browser.evaluate(lineOf('mh_amcl')), await browser.evaluate(lineOf('amcl'))], there);
  assert.notEqual(there[0], there[1]);
});
