// The page of a live run, used by keys alone. CASTAWAY_CHROMIUM: the browser; CASTAWAY_PROGRAM: castaway.
import assert from 'node:assert/strict';
import {after as afterAll, before as beforeAll, test} from 'node:test';
import {Chromium} from './chromium.mjs';
import {startLive} from './live_program.mjs';

const kShift = 8;
const kRim = 4;  // [px] Of the outline.
const kMost = 200;  // Presses of Tab around the page.
let browser;
let live;

beforeAll(async () => {
  live = await startLive(process.env.CASTAWAY_PROGRAM, ['--localizer', 'mh_amcl', '--localizer', 'amcl']);
  browser = await Chromium.start(process.env.CASTAWAY_CHROMIUM);
  await browser.open(live.url, {width: 1440, height: 900});
  await browser.until(`document.getElementById('castaway-live').dataset.ready === 'true'
    && !document.querySelector('.view-choice').hidden && !document.querySelector('.start').hidden`);
  await press('Escape');
});
afterAll(async () => {
  await browser.close();
  live.server.kill('SIGTERM');
});

const kTime = `Number(document.getElementById('castaway-live').dataset.time ?? 0)`;
const kPlaying = `document.querySelector('.play').textContent === 'Pause'`;
const kName = `((it) => it.getAttribute('aria-label') ?? (it.closest('label') ?? it).textContent)`;
const press = (key, code = key, modifiers = 0) => browser.key(key, code, modifiers);
const focused = () => browser.evaluate(`document.activeElement === document.body ? null : ${kName}(document.activeElement)`);
const logged = (word) => browser.until(`document.querySelector('.log').textContent.includes('${word}')`);

/** Presses Tab until the control with this name has the focus. */
async function goTo(name) {
  for (let presses = 0; presses < kMost; ++presses) {
    if (await focused() === name) return;
    await press('Tab');
  }
  assert.fail(`no Tab leads to ${name}`);
}

/** The name of what has the focus, the part of the page that it is in, and whether a reader sees that it has it. */
const kStop = `(() => {
  const it = document.activeElement;
  if (it === document.body) return null;
  const {left, top, right, bottom} = it.getBoundingClientRect();
  const {outlineStyle, outlineWidth} = getComputedStyle(it);
  const part = [...document.getElementById('castaway-live').children].findIndex((child) => child.contains(it));
  return {name: ${kName}(it), part, index: [...document.querySelectorAll('*')].indexOf(it),
    outlined: outlineStyle !== 'none' && parseFloat(outlineWidth) >= 2,
    inside: right > left && bottom > top && left >= ${kRim} && top >= ${kRim} && right <= innerWidth - ${kRim} &&
      bottom <= innerHeight - ${kRim}};
})()`;

/** All stops of Tab from the beginning of the page to its end. */
async function stops() {
  const found = [];
  for (let presses = 0; presses < kMost; ++presses) {
    await press('Tab');
    const stop = await browser.evaluate(kStop);
    if (!stop || stop.index <= (found.at(-1)?.index ?? -1)) return found;
    found.push(stop);
  }
  assert.fail('Tab does not come to an end');
}

const kControls = `[...document.querySelectorAll('button, select, input, canvas[tabindex], summary, a[href], .log')]
  .filter((it) => it.checkVisibility({visibilityProperty: true}) && !it.disabled).map(${kName})`;

/** Tab leads to all controls, and each is seen to have the focus. Returns the stops. */
async function assertReachable() {
  const found = await stops();
  assert.deepEqual(found.map(({name}) => name), await browser.evaluate(kControls));
  assert.deepEqual(found.filter(({outlined, inside}) => !outlined || !inside), []);
  return found;
}

test('Tab reaches every control, seen to have the focus, in the order of the page', async () => {
  const found = await assertReachable();
  const parts = found.map(({part}) => part);
  assert.deepEqual(parts, [...parts].sort((a, b) => a - b));
  const order = ['Play', 'Teleport', 'Anywhere', 'Break it', 'Time', 'Curve', 'What happened', 'truth'];
  const places = order.map((name) => found.findIndex((stop) => stop.name === name));
  assert.ok(places.every((place, i) => place >= 0 && (i === 0 || place > places[i - 1])), places.join());
});

test('the same in the 3-D view', async () => {
  await press('3', 'Digit3');
  await browser.until(`!document.querySelector('canvas.view-3d').hidden`);
  await assertReachable();
  await press('3', 'Digit3');
  await browser.until(`document.querySelector('canvas.view-3d').hidden`);
});

test('Shift and Tab lead back', async () => {
  await goTo('Step a scan');
  await press('Tab', 'Tab', kShift);
  assert.equal(await focused(), 'Play');
});

test('plays by Enter, pauses by Space', async () => {
  await goTo('Play');
  await press('Enter');
  await browser.until(`${kPlaying} && ${kTime} > 1`);
  await press(' ', 'Space');
  await browser.until(`!(${kPlaying})`);
  assert.equal(await focused(), 'Play');
});

test('steps a scan', async () => {
  for (const [name, ...key] of [['Step a scan', 'Enter'], ['Step a scan', ' ', 'Space'], ['Speed', 'Tab']]) {
    const before = await browser.evaluate(kTime);
    await goTo(name);
    await press(...key);
    if (name === 'Speed') await press('.', 'Period');
    await browser.until(`${kTime} > ${before}`);
  }
});

test('chooses a speed', async () => {
  await goTo('Speed');
  await press('ArrowDown');
  await browser.until(`document.querySelector('[aria-label="Speed"]').value === '2'`);
  await press('ArrowUp');
  await browser.until(`document.querySelector('[aria-label="Speed"]').value === '1'`);
});

test('chooses a tool', async () => {
  const chosen = `[...document.querySelectorAll('[data-tool][aria-pressed="true"]')].map(({textContent}) => textContent).join()`;
  assert.equal(await browser.evaluate(chosen), 'Teleport');
  await goTo('Carry');
  await press(' ', 'Space');
  assert.equal(await browser.evaluate(chosen), 'Carry');
  assert.match(await browser.evaluate(`document.querySelector('.tools [role="status"]').textContent`), /carried/);
});

test('kidnaps, and jumps to the kidnap, whose mark keeps the focus while the run goes on', async () => {
  await goTo('Turn');
  await press('Enter');
  await press('.', 'Period');
  await logged('turn');
  await press('Escape');
  await goTo('Play');
  await press('Enter');
  await browser.until(`document.querySelector('.mark')`);
  const mark = await browser.evaluate(`${kName}(document.querySelector('.mark'))`);
  await goTo(mark);
  const before = await browser.evaluate(kTime);
  await browser.until(`${kTime} > ${before} + 1`);
  assert.equal(await focused(), mark);
  await press('Enter');
  await browser.until(`${kTime} < ${before}`);
  await press('Escape');
  await browser.until(`${kTime} > ${before}`);
});

test('moves the slider of time, and goes on from there', async () => {
  await goTo('Time');
  await press('Home');
  await browser.until(`${kTime} < 0.3`);
  const first = await browser.evaluate(kTime);
  await press('ArrowRight');
  await browser.until(`${kTime} > ${first}`);
  await press('End');
  await browser.until(`${kTime} > 1`);
  await press('ArrowLeft');
  const past = await browser.evaluate(kTime);
  await goTo('Back to now');
  await press('Enter');
  await browser.until(`${kTime} > ${past}`);
  assert.equal(await focused(), 'Pause');
  await goTo('Time');
  await press('Home');
  await goTo('Go on from here');
  await press('Enter');
  await browser.until(`!document.querySelector('.log li') && ${kPlaying}`);  // It goes on playing.
  assert.deepEqual(browser.errors, []);
});

test('chooses a layer', async () => {
  const before = await browser.evaluate(`document.querySelector('.layers input').checked`);
  await goTo('truth');
  await press(' ', 'Space');
  assert.equal(await browser.evaluate(`document.querySelector('.layers input').checked`), !before);
});
