// A real report, opened from disk and used. CASTAWAY_CHROMIUM: the browser; CASTAWAY_REPORT: the page;
// CASTAWAY_SCREENSHOTS: folder that pictures are left in (optional).
import assert from 'node:assert/strict';
import {mkdirSync, mkdtempSync, readdirSync, readFileSync, rmSync, writeFileSync} from 'node:fs';
import {tmpdir} from 'node:os';
import {join, resolve} from 'node:path';
import {after as afterAll, before as beforeAll, test} from 'node:test';
import {pathToFileURL} from 'node:url';
import {Chromium} from './chromium.mjs';
import {kPixels3d, kStill3d} from './pixels3d.mjs';

const url = pathToFileURL(resolve(process.env.CASTAWAY_REPORT)).href;
const folder = process.env.CASTAWAY_SCREENSHOTS;
let browser;

beforeAll(async () => {
  browser = await Chromium.start(process.env.CASTAWAY_CHROMIUM);
});
afterAll(() => browser.close());

const kFrames = 'new Promise((r) => requestAnimationFrame(() => requestAnimationFrame(() => r())))';

async function open(options) {
  browser.errors.length = 0;
  browser.requests.length = 0;
  await browser.open(url, options);
  await browser.until("document.querySelector('#castaway-player[data-time]')");
  await browser.evaluate(kFrames);
}

const time = () => browser.evaluate("Number(document.querySelector('#castaway-player').dataset.time)");

/** What the map shows, as one number. */
const mapSum = () => browser.evaluate(`(() => {
  const canvas = document.querySelector('canvas.map');
  const {data} = canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height);
  let sum = 0;
  for (let i = 0; i < data.length; ++i) sum = (sum * 31 + data[i]) % 4294967291;
  return sum;
})()`);

/** Does something in the page and waits until it is drawn. */
async function act(expression) {
  await browser.evaluate(expression);
  await browser.evaluate(kFrames);
}

async function press(...key) {
  await browser.key(...key);
  await browser.evaluate(kFrames);
}

const focusMap = () => browser.evaluate("document.querySelector('canvas.map').focus()");

async function picture(name, whole = false) {
  if (!folder) return;
  mkdirSync(folder, {recursive: true});
  writeFileSync(join(folder, `${name}.png`), await browser.screenshot(whole));
}

function noErrors() {
  assert.deepEqual(browser.errors, []);
  assert.deepEqual(browser.requests.filter((asked) => !/^(file|data|blob):/.test(asked)), []);
}

test('opens where a localizer was lost and did not recover, else at the first kidnap', async () => {
  await open();
  const {open_s: wanted, events} = await browser.evaluate(`JSON.parse(document.getElementById('castaway-page').textContent)`);
  assert.ok(events.some((event) => event.kind === 'kidnap' && event.time === wanted));
  assert.ok(await time() >= wanted && await time() < wanted + 0.3);
});

test('switches of layers and cards are beside the map', async () => {
  await open({width: 1280, height: 900});
  const boxes = await browser.evaluate(`['canvas.map', '.layers', '.card'].map((selector) => {
    const {left, right, top} = document.querySelector('#castaway-player ' + selector).getBoundingClientRect();
    return {left, right, top};
  })`);
  assert.ok(boxes[1].left >= boxes[0].right && boxes[2].left >= boxes[0].right);
  const [bottom, map] = await browser.evaluate(`['.layers', 'canvas.map'].map((selector) =>
    document.querySelector('#castaway-player ' + selector).getBoundingClientRect().bottom)`);
  assert.ok(bottom < map + 120, `${bottom}, ${map}`);
});

test('draws a check mark for every recovery that is not too near to another one', async () => {
  await open();
  const events = await browser.evaluate(`JSON.parse(document.getElementById('castaway-page').textContent).events`);
  const recoveries = events.filter(({kind}) => kind === 'recovery');
  assert.ok(recoveries.length > 0);
  const marks = await browser.evaluate(`[...document.querySelectorAll('.lane-marks .mark.recovery')]
    .map((mark) => [mark.textContent, mark.getAttribute('aria-label')])`);
  assert.ok(marks.length > 0 && marks.length <= recoveries.length);
  assert.ok(marks.every(([text, label]) => text === '\u2713' && /^Jump to .*, at [\d.]+ s$/.test(label)));
  await press('Home');
  await act("document.querySelector('.lane-marks .mark.recovery').click()");
  const at = await time();
  assert.ok(recoveries.some((event) => Math.abs(event.time - at) < 1e-3), `${at}`);
});

test('colours the path by the error of a localizer', async () => {
  await open();
  await press('Home');
  const map = await mapSum();
  const hidden = "document.querySelector('.error-signs').hidden";
  assert.equal(await browser.evaluate(hidden), true);
  const choose = (value) => act(`(() => {
    const select = document.querySelector('[aria-label="Localizer whose error colours the path"]');
    select.value = '${value}';
    select.dispatchEvent(new Event('change'));
  })()`);
  await choose(1);
  assert.equal(await browser.evaluate(hidden), false);
  assert.notEqual(await mapSum(), map);
  assert.match(await browser.evaluate("document.querySelector('.error-signs').textContent"), /position error \[m\]/);
  await choose(-1);
  assert.equal(await mapSum(), map);
  noErrors();
});

test('says at its head when and where it was made', async () => {
  await open();
  const head = await browser.evaluate("document.getElementById('castaway-made-place').parentElement.textContent");
  assert.match(head, /castaway [0-9.]+, made on \d{4}-\d\d-\d\d \d\d:\d\d UTC, .* cores?(, at commit [0-9a-f]{12})?$/);
});

test('opens at the moment of its address', async () => {
  await browser.open(`${url}#t=7`, {});
  await browser.until("document.querySelector('#castaway-player[data-time]')");
  await browser.evaluate(kFrames);
  assert.ok(Math.abs((await time()) - 7) < 0.25);
});

for (const [name, options] of Object.entries({
  'wide-light': {width: 1280, height: 900}, 'wide-dark': {width: 1280, height: 900, dark: true},
  'narrow-light': {width: 390, height: 844, mobile: true},
  'narrow-dark': {width: 390, height: 844, dark: true, mobile: true},
})) {
  test(`opens without an error and fits the window: ${name}`, async () => {
    await open(options);
    await press('ArrowRight');
    const [ink, free] = await browser.evaluate(`['--ink', '--free'].map((name) =>
      getComputedStyle(document.documentElement).getPropertyValue(name).trim())`);
    assert.equal(free === '#ffffff', !options.dark);
    assert.notEqual(ink, free);
    assert.equal(await browser.evaluate('document.querySelectorAll("#castaway-player .uplot, #castaway-curves .uplot").length'), 6)
    assert.equal(await browser.evaluate('document.querySelectorAll(".plots .uplot").length'), 2);
    assert.ok(await browser.evaluate('document.documentElement.scrollWidth <= innerWidth'), 'too wide');
    await act(`document.querySelector('#castaway-player .mark.kidnap').click()`);
    await picture(name);
    await picture(`${name}-page`, true);
    noErrors();
  });
}

test('plays and stops', async () => {
  await open();
  const [before, map] = [await time(), await mapSum()];
  await act("document.querySelector('.play').click()");
  await browser.until(`Number(document.querySelector('#castaway-player').dataset.time) > ${before + 0.5}`);
  await act("document.querySelector('.play').click()");
  const stopped = await time();
  assert.notEqual(await mapSum(), map);
  await browser.evaluate(kFrames);
  assert.equal(await time(), stopped);
  noErrors();
});

test('is led by the keyboard', async () => {
  await open();
  await focusMap();
  await press('End');
  const end = await time();
  await press('ArrowLeft');
  const before = await time();
  assert.ok(before < end && before > end - 0.5, `${before}, ${end}`);
  await press('Home');
  const begin = await time();
  await press('ArrowRight');
  assert.ok(await time() > begin);
  const map = await mapSum();
  await press('+');
  assert.notEqual(await mapSum(), map);
  await press('ArrowDown');
  const event = await time();
  await press(' ', 'Space');
  await browser.until(`Number(document.querySelector('#castaway-player').dataset.time) > ${event}`);
  await press(' ', 'Space');
  noErrors();
});

test('scrubs by the slider, and the map with it', async () => {
  await open();
  const map = await mapSum();
  await act(`(() => {
    const slider = document.querySelector('.timeline input');
    slider.value = 0.5 * slider.max;
    slider.dispatchEvent(new Event('input'));
  })()`);
  assert.ok(await time() > 1);
  assert.notEqual(await mapSum(), map);
  assert.match(await browser.evaluate(
    "document.querySelector('.timeline input').getAttribute('aria-valuetext')"), /mh_amcl/);
});

test('a mark and a row of the events lead to the kidnap', async () => {
  await open();
  const wanted = await browser.evaluate(`JSON.parse(document.getElementById('castaway-page').textContent)
    .events.find((event) => event.kind === 'kidnap').time`);
  await act("document.querySelector('#castaway-player .mark.kidnap').click()");
  assert.ok(Math.abs(await time() - wanted) < 1e-3);
  await press('Home');
  await act(`[...document.querySelectorAll('tr[data-time]')].find((row) => /kidnap/.test(row.textContent))
    .querySelector('button').click()`);
  assert.ok(Math.abs(await time() - wanted) < 1e-3);
});

test('a click on a curve leads there; a drag zooms all curves', async () => {
  await open();
  await act("document.querySelector('.uplot').scrollIntoView()");
  const box = await browser.evaluate(`(() => {
    const {left, top, width, height} = document.querySelector('.uplot .u-over').getBoundingClientRect();
    return {left, top, width, height};
  })()`);
  const at = (share) => [box.left + share * box.width, box.top + box.height / 2];
  await browser.drag([at(0.5)]);
  await browser.evaluate(kFrames);
  const middle = await time();
  assert.ok(middle > 1);
  const heads = () => browser.evaluate(
    "[...document.querySelectorAll('.playhead')].map((head) => head.style.transform)");
  const before = await heads();
  assert.equal(new Set(before).size, 1);
  await browser.drag([at(0.4), at(0.45), at(0.6)]);
  await browser.evaluate(kFrames);
  await browser.evaluate(kFrames);
  const after = await heads();
  assert.equal(new Set(after).size, 1);
  assert.notEqual(after[0], before[0]);
  await act("document.getElementById('castaway-zoom').click()");
  await browser.evaluate(kFrames);
  assert.deepEqual(await heads(), before);
  noErrors();
});

test('curves and map are saved', async () => {
  await open();
  const saved = mkdtempSync(join(tmpdir(), 'castaway-saved-'));
  await browser.send('Page.setDownloadBehavior', {behavior: 'allow', downloadPath: saved});
  const save = (text) => browser.evaluate(`[...document.querySelectorAll('.curves-head button')]
    .find((button) => button.textContent === ${JSON.stringify(text)}).click()`);
  for (const text of ['Curves as CSV', 'Curves as PNG', 'Curves as SVG', 'Map as PNG']) await save(text);
  const done = () => readdirSync(saved).filter((name) => !name.endsWith('.crdownload'));
  for (let tries = 0; tries < 200 && done().length < 4; ++tries) await new Promise((r) => setTimeout(r, 50));
  const [csv, curves, svg, map] = done().sort().map((name) => readFileSync(join(saved, name)));
  const lines = csv.toString().trimEnd().split('\n');
  assert.ok(lines[0].startsWith('time_s,mh_amcl.error_m,'));
  assert.equal(lines.length, 1 + 120);  // 12 s at 10 Hz.
  assert.match(svg.toString(), /^<svg [^]*Position error \[m\][^]*<path d="M[^"]*L[^"]*"[^]*mh_amcl<\/text>[^]*<\/svg>\n$/);
  assert.doesNotMatch(svg.toString(), /NaN|undefined|null/);
  for (const image of [curves, map]) {
    assert.deepEqual([...image.subarray(0, 4)], [0x89, 0x50, 0x4e, 0x47]);
    assert.ok(image.length > 5000);
  }
  rmSync(saved, {recursive: true});
  noErrors();
});

test('layers, zoom and following change the map', async () => {
  await open();
  await act("document.querySelector('#castaway-player .mark.kidnap').click()");
  let map = await mapSum();
  const changes = [
    "document.querySelector('.layers input').click()", "document.querySelectorAll('.layers input')[3].click()",
    "document.querySelector('[aria-label^=Closer]').click()",
    "document.querySelector('[aria-label^=Follow]').click()",
    "document.querySelector('[aria-label^=Whole]').click()"];
  for (const change of changes) {
    await act(change);
    const now = await mapSum();
    assert.notEqual(now, map, change);
    map = now;
  }
  const box = await browser.evaluate(`(() => {
    document.querySelector('canvas.map').scrollIntoView();
    const {left, top, width, height} = document.querySelector('canvas.map').getBoundingClientRect();
    return [left + width / 2, top + height / 2];
  })()`);
  await browser.drag([box, [box[0] + 60, box[1] + 30]]);
  await browser.evaluate(kFrames);
  assert.notEqual(await mapSum(), map);
});

test('a finger moves the map, two zoom it, and the page stands still', async () => {
  await open({width: 390, height: 844, mobile: true});
  const [x, y] = await browser.evaluate(`(() => {
    document.querySelector('canvas.map').scrollIntoView();
    const {left, top, width, height} = document.querySelector('canvas.map').getBoundingClientRect();
    return [left + width / 2, top + height / 2];
  })()`);
  const scrolled = await browser.evaluate('scrollY');
  const first = await mapSum();
  await browser.touch([[[x, y]], [[x + 20, y + 30]], [[x + 40, y + 60]]]);
  await browser.evaluate(kFrames);
  const moved = await mapSum();
  assert.notEqual(moved, first);
  await browser.touch([[[x - 20, y], [x + 20, y]], [[x - 40, y], [x + 40, y]], [[x - 80, y], [x + 80, y]]]);
  await browser.evaluate(kFrames);
  assert.notEqual(await mapSum(), moved);
  assert.equal(await browser.evaluate('scrollY'), scrolled);
  await picture('narrow-zoomed');
  noErrors();
});

test('the switch changes the colours of page and map', async () => {
  await open();
  const map = await mapSum();
  await act("document.querySelector('.theme').click()");  // auto -> light: the same
  await act("document.querySelector('.theme').click()");  // -> dark
  assert.equal(await browser.evaluate('document.documentElement.dataset.theme'), 'dark');
  assert.notEqual(await mapSum(), map);
  await act("document.querySelector('.theme').click()");
  noErrors();
});

async function still3d() {
  await browser.evaluate(kStill3d);
  return browser.evaluate(kPixels3d);
}
const press3d = () => act(`[...document.querySelectorAll('#castaway-player button')]
  .find((button) => button.textContent === '3-D').click()`);

test('the 3-D view shows the moment of the player', async () => {
  await open({width: 1440, height: 900});
  await act("document.querySelector('#castaway-player .mark.kidnap').click()");
  const height = await browser.evaluate("document.querySelector('#castaway-player').offsetHeight");
  await press3d();
  const kidnapped = await still3d();
  assert.ok(kidnapped.colors > 300, `${kidnapped.colors} colours`);
  await picture('view-3d');
  assert.equal(await browser.evaluate("document.querySelector('#castaway-player').offsetHeight"), height);
  await act("document.querySelector('[aria-label^=\"Last scan\"]').click()");
  const last = await still3d();
  assert.notEqual(last.sum, kidnapped.sum);
  await act("document.querySelector('#castaway-player .mark.kidnap').click()");
  assert.equal((await still3d()).sum, kidnapped.sum, 'the same moment looks the same');
  await act("document.querySelectorAll('.layers input')[1].click()");
  assert.notEqual((await still3d()).sum, kidnapped.sum, 'without estimates');
  noErrors();
});

test('the 3-D view is turned by keys and by a finger, and the player stands still', async () => {
  await open({width: 390, height: 844, mobile: true});
  await press3d();
  const seen = [await still3d()];
  const begin = await time();
  await act("document.querySelector('canvas.view-3d').focus()");
  await press('ArrowRight');
  seen.push(await still3d());
  const [x, y] = await browser.evaluate(`(() => {
    document.querySelector('canvas.view-3d').scrollIntoView();
    const {left, top, width, height} = document.querySelector('canvas.view-3d').getBoundingClientRect();
    return [left + width / 2, top + height / 2];
  })()`);
  await browser.touch([[[x, y]], [[x + 30, y]], [[x + 60, y]]]);
  seen.push(await still3d());
  await browser.touch([[[x - 20, y], [x + 20, y]], [[x - 60, y], [x + 60, y]]]);
  seen.push(await still3d());
  assert.equal(new Set(seen.map(({sum}) => sum)).size, seen.length);
  assert.equal(await time(), begin);
  assert.ok(await browser.evaluate('document.documentElement.scrollWidth <= innerWidth'), 'too wide');
  noErrors();
});

test('everything that is pressed has a name', async () => {
  await open();
  const nameless = await browser.evaluate(`[...document.querySelectorAll('button, select, input')].filter(
    (it) => !it.getAttribute('aria-label') && !it.textContent.trim() && !it.closest('label')).length`);
  assert.equal(nameless, 0);
});
