// Pages of an experiment, a comparison, a run and a campaign at the widths of a wide screen and of a telephone, light and dark.
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
  campaign: 'campaign/campaign.html', costs: 'campaign/costs.html',
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
