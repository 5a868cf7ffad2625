// What a live run costs, as JSON: node web/test/browser/live_cost.mjs CASTAWAY CHROMIUM HOURS
// Twenty people, three localizers, the page in a window of 1440 x 900; then HOURS of simulated time at 100 x.
import {toScreen} from '../../src/view.js';
import {Chromium} from './chromium.mjs';
import {startLive} from './live_program.mjs';
import {kHistory, kProbe} from './live_probe.mjs';
import {memoryOf} from './process_memory.mjs';

const kRate = 10;  // [Hz] Scans.
const kLocalizers = ['mh_amcl', 'amcl', 'mh_amcl:paper'];
const kSeconds = 30;  // [s] At each speed.
const kMoves = 60;
const kKidnaps = 10;
const kNames = `[...document.querySelectorAll('.card .name')].map(({textContent}) => textContent)`;
const kSampleEvery = 600;  // [s] Of simulated time.

const [program, chromium, hours] = process.argv.slice(2);
const wait = (seconds) => new Promise((resolve) => setTimeout(resolve, 1000 * seconds));
const log = (text) => process.stderr.write(`live_cost: ${text}\n`);

const live = await startLive(program, ['office/people', '--set', `lidar.rate_hz=${kRate}`,
  ...kLocalizers.flatMap((name) => ['--localizer', name])]);
const browser = await Chromium.start(chromium);
await browser.send('Page.addScriptToEvaluateOnNewDocument', {source: kProbe});
await browser.open(live.url, {width: 1440, height: 900});
await browser.until(`document.getElementById('castaway-live').dataset.ready === 'true'`);

const press = (text) => browser.evaluate(`[...document.querySelectorAll('#castaway-live button')]
  .find(({textContent}) => textContent === ${JSON.stringify(text)}).click()`);
const setSpeed = (speed) => browser.evaluate(`(() => {
  const select = document.querySelector('[aria-label="Speed"]');
  select.value = '${speed}';
  select.dispatchEvent(new Event('change'));
})()`);
const look = () => browser.evaluate('({redraws: probe.redraws, wall: performance.now(), status: probe.status})');

/** Plays for a while at a speed: redraws a second, simulated seconds a second, the first and last time told. */
async function cruise(speed) {
  await setSpeed(speed);
  await wait(5);
  await browser.evaluate('probe.status.length = 0');
  const before = await look();
  await wait(kSeconds);
  const after = await look();
  const [first, last] = [after.status[0], after.status.at(-1)];
  const told = {redraws_hz: (1000 * (after.redraws - before.redraws)) / (after.wall - before.wall),
    times_real: (1000 * (last.now - first.now)) / (last.wall - first.wall), from_s: first.now, to_s: last.now};
  log(`${speed} x: ${JSON.stringify(told)}`);
  return told;
}

/** Scans that came between two times, scans that were due then, and answers of each localizer. */
async function answered({from_s: from, to_s: to}) {
  const rows = (await browser.evaluate(kHistory)).filter(([time]) => time > from && time <= to);
  return {due: Math.round((to - from) * kRate), came: rows.length,
    answers: kLocalizers.map((_, k) => rows.filter((row) => row[1 + k]).length)};
}

/** The point of the window where the robot is. */
async function robotOnScreen() {
  const [left, top, view, {x, y}] = await browser.evaluate(`(() => {
    const {dataset} = document.getElementById('castaway-live');
    const box = document.querySelector('canvas.map').getBoundingClientRect();
    return [box.left, box.top, JSON.parse(dataset.view), JSON.parse(dataset.truth)];
  })()`);
  const [px, py] = toScreen(view, x, y);
  return [left + px, top + py];
}

/** Drags the robot about and back: ms from each move to the frame with the ghost. */
async function dragLatencies() {
  const mouse = (type, [x, y]) =>
    browser.send('Input.dispatchMouseEvent', {type, x, y, button: 'left', buttons: 1, clickCount: 1});
  await browser.evaluate('probe.taken.ghost.length = 0');
  const [x, y] = await robotOnScreen();
  await mouse('mousePressed', [x, y]);
  for (let i = 1; i <= kMoves; ++i) {
    await mouse('mouseMoved', [x + 30 * Math.sin(i / 5), y + 30 * Math.cos(i / 5)]);
    await wait(0.05);
  }
  await mouse('mouseReleased', [x, y]);
  return browser.evaluate('probe.taken.ghost');
}

/** ms from each press on "Anywhere" to the frame with the line of the kidnap, which is seen for three seconds. */
async function kidnapLatencies() {
  await browser.evaluate('probe.taken.kidnap.length = 0');
  for (let i = 1; i <= kKidnaps; ++i) {
    await wait(4);
    await press('Anywhere');
    await browser.until(`probe.taken.kidnap.length === ${i}`);
  }
  return browser.evaluate('probe.taken.kidnap');
}

async function sample() {
  await browser.send('HeapProfiler.collectGarbage');
  const {usedSize} = await browser.send('Runtime.getHeapUsage');
  return {...memoryOf(live.server.pid), page: usedSize / 2 ** 20};
}

/** Memory over simulated time, the page open. */
async function memory() {
  await setSpeed(100);
  const now = () => browser.evaluate('probe.status.at(-1).now');
  const begin = await now();
  const samples = [];
  for (let time = begin; time <= begin + 3600 * hours;) {
    time = await now();
    if (time < begin + kSampleEvery * samples.length) {
      await wait(1);
      continue;
    }
    samples.push({time_s: time - begin, ...(await sample())});
    await browser.evaluate('probe.status.splice(0, probe.status.length - 1)');
    log(JSON.stringify(samples.at(-1)));
  }
  return samples;
}

async function measure() {
  await press('Play');
  const figures = {localizers: await browser.evaluate(kNames), real: await cruise(1)};
  figures.real_ghost_ms = await dragLatencies();
  figures.kidnap_ms = await kidnapLatencies();
  figures.fast = await cruise(20);
  figures.fast_scans = await answered(figures.fast);
  figures.fast_ghost_ms = await dragLatencies();
  figures.memory = await memory();
  return figures;
}

try {
  console.log(JSON.stringify(await measure()));
} finally {
  await browser.close();
  live.server.kill('SIGTERM');
}
