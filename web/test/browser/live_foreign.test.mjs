// A program as a localizer of a live run. CASTAWAY_CHROMIUM: the browser; CASTAWAY_PROGRAM: castaway.
import assert from 'node:assert/strict';
import {execFileSync} from 'node:child_process';
import {after, before, test} from 'node:test';
import {Chromium} from './chromium.mjs';
import {kTime, LivePage} from './live_page.mjs';
import {startLive} from './live_program.mjs';

const kCastaway = process.env.CASTAWAY_PROGRAM;
let browser;
let page;
let live;

before(async () => {
  live = await startLive(kCastaway, ['--localizer', 'mh_amcl', '--localizer', `program:${kCastaway} serve mh_amcl`,
    '--set', 'localizers.1.name=served', '--set', 'events=[]', '--set', 'people.count=0']);
  browser = await Chromium.start(process.env.CASTAWAY_CHROMIUM);
  page = new LivePage(browser);
  await browser.open(live.url, {width: 1440, height: 900});
  await browser.until(`document.getElementById('castaway-live').dataset.ready === 'true'`);
});
after(async () => {
  await browser.close();
  live.server.kill('SIGTERM');
});

/** How many programs of this run there are, among all that descend from its process; others' tests have such programs, too. */
function programs() {
  const all = execFileSync('ps', ['-eo', 'pid=,ppid=,args='], {encoding: 'utf8'}).trim().split('\n').map((line) => {
    const [pid, parent, ...args] = line.trim().split(/\s+/);
    return {pid: Number(pid), parent: Number(parent), command: args.join(' ')};
  });
  const under = (root) => all.filter(({parent}) => parent === root).flatMap((child) => [child, ...under(child.pid)]);
  return under(live.server.pid).filter(({command}) => command.startsWith(`${kCastaway} serve mh_amcl`)).length;
}
const states = () => browser.evaluate(`[...document.querySelectorAll('.card .state')].map(({textContent}) => textContent)`);

test('it answers every scan', async () => {
  await page.playUntil(`${kTime} > 4`);
  assert.deepEqual(await states(), ['right', 'right']);
  assert.equal(programs(), 1);
});

test('the run goes back, and the program begins again', async () => {
  await page.press('Anywhere');
  await page.playUntil(`${kTime} > 6`);
  await page.goBack(2);
  await page.playUntil(`${kTime} > 4`);
  assert.deepEqual(await states(), ['right', 'right']);
  assert.equal(programs(), 1);
});

test('what cannot be loaded does not end it, and another world begins it again', async () => {
  await page.choose({'broken.yaml': 'objects: [3'});
  await page.noted('broken.yaml');
  await page.playUntil(`${kTime} > 5`);
  assert.deepEqual(await states(), ['right', 'right']);
  await page.choose({'room.yaml': `name: room
extent: {min: [-3, -3], max: [3, 3]}
objects:
  - wall: {name: outer, closed: true, points: [[-3, -3], [3, -3], [3, 3], [-3, 3]]}
  - box: {name: crate, at: [1.5, 1], size: [0.8, 0.5, 1]}
`});
  await browser.until(`document.querySelector('h1').textContent === 'room'`);
  await page.playUntil(`${kTime} > 1`);
  assert.equal(programs(), 1);
  assert.deepEqual(browser.errors, []);
});
