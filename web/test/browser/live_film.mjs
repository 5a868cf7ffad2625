// Films the page of a live run: node web/test/browser/live_film.mjs CASTAWAY CHROMIUM FOLDER
// The robot is dragged away, a localizer finds it, things are put into its way, and the run goes back. Leaves PNGs in
// FOLDER, and there `frames.txt`: the arguments of img2webp for them. Every step waits for what the page shows.
import {mkdirSync, writeFileSync} from 'node:fs';
import {join} from 'node:path';
import {Chromium} from './chromium.mjs';
import {Film} from './film.mjs';
import {kTime, LivePage} from './live_page.mjs';
import {startLive} from './live_program.mjs';

const [program, chromium, folder] = process.argv.slice(2);
const kSize = {width: 1280, height: 880};
const kScale = 0.75;  // 960 x 660 pixels.
const kBegin = 6;  // [s] The film begins at this simulated time.
const kGoal = [6.5, -0.3];  // [m] Where the robot is dragged to.
const kBox = [5.0, -2.4];  // [m] Where a box is put.

mkdirSync(folder, {recursive: true});
const live = await startLive(program, ['lab/kidnap', '--set', 'seed=1', '--set', 'events=[]', '--set', 'people.count=0',
  '--localizer', 'mh_amcl', '--localizer', 'amcl']);
const browser = await Chromium.start(chromium);
await browser.open(live.url, kSize);
await browser.until(`document.getElementById('castaway-live').dataset.ready === 'true'`);
const film = new Film(browser, folder);

const page = new LivePage(browser);
const kStates = `[...document.querySelectorAll('.card .state')].map(({textContent}) => textContent)`;
const buttonOf = (text) => `[...document.querySelectorAll('#castaway-live button')]
  .find(({textContent, hidden, offsetWidth}) => textContent === ${JSON.stringify(text)} && !hidden && offsetWidth)`;
const has = (text) => browser.evaluate(`Boolean(${buttonOf(text)})`);
const time = () => browser.evaluate(kTime);

/** The middle of an element, in the window. */
const middleOf = (expression) => browser.evaluate(`(() => {
  const {left, top, width, height} = (${expression}).getBoundingClientRect();
  return [left + width / 2, top + height / 2];
})()`);

const onScreen = (x, y) => page.onScreen(x, y);

async function robot() {
  const {x, y} = await page.truth();
  return onScreen(x, y);
}

const click = async (expression) => film.click(await middleOf(expression));

/** Films until the expression holds, and `more` seconds after that. */
async function filmUntil(expression, more = 0) {
  await film.until(expression);
  await film.roll(more);
}

/** Plays to a time, which is not filmed. */
async function playTo(begin) {
  await browser.evaluate(`${buttonOf('Play')}.click()`);
  await browser.until(`${kTime} >= ${begin}`);
}

/** The hand chooses a speed. The list itself is drawn by no page and seen in no picture. */
async function setSpeed(speed) {
  const select = `document.querySelector('[aria-label="Speed"]')`;
  await film.moveTo(await middleOf(select));
  await browser.evaluate(`(${select}.value = '${speed}', ${select}.dispatchEvent(new Event('change')))`);
  await film.shoot();
}

/** Puts a box there and people ahead, seen in 3-D, as far as this page has that. */
async function changeWorld() {
  if (await has('Box')) {
    await click(buttonOf('Box'));
    await film.click(await onScreen(...kBox));
  }
  for (const text of ['3-D', 'People ahead', '2-D']) {
    if (!(await has(text))) continue;
    await click(buttonOf(text));
    await film.roll(text === '2-D' ? 0 : 0.8);
  }
}

async function play() {
  await playTo(kBegin);
  await film.begin([700, 330]);
  await film.roll(0.4);
  const taken = await time();

  await setSpeed(0.25);  // A localizer that is lost is right again within some tenths of a second.
  await film.moveTo(await robot());
  await film.moveTo(await robot());  // It has gone on.
  await film.press();
  await film.moveTo(await onScreen(...kGoal));
  await film.release();
  await filmUntil(`document.querySelector('.log li') && ${kStates}[0].startsWith('right') && !${kStates}[1].startsWith('right')`, 0.2);
  await setSpeed(1);
  await film.roll(0.4);

  await changeWorld();

  // The timeline grows while the hand moves: aim a second before the kidnap.
  const slider = `document.querySelector('.timeline input')`;
  const [left, top, width, min, max] = await browser.evaluate(`(() => {
    const {left, top, width, height} = ${slider}.getBoundingClientRect();
    return [left, top + height / 2, width, Number(${slider}.min), Number(${slider}.max)];
  })()`);
  await film.click([left + 8 + ((taken - 1 - min) / (max - min)) * (width - 16), top]);
  await filmUntil(buttonOf('Go on from here'), 0.6);
  await click(buttonOf('Go on from here'));
  await filmUntil(`!document.querySelector('.log li')`, 0.2);
  await film.roll(0.9);
}

try {
  await play();
  await film.shrink(kScale);
  writeFileSync(join(folder, 'frames.txt'), film.sheet());
  process.stderr.write(`live_film: ${film.summary()}\n`);
} finally {
  await browser.close();
  live.server.kill('SIGTERM');
}
