// What the page of a live run holds of it, and what the report of the saved run holds.
import assert from 'node:assert/strict';
import {execFileSync} from 'node:child_process';
import {existsSync, mkdtempSync, readFileSync} from 'node:fs';
import {join} from 'node:path';
import {gunzipSync} from 'node:zlib';
import {errorsOf, statesOf} from '../../src/measures.js';
import {Recording} from '../../src/recording.js';

const kNotOfTheRun = ['alarm on', 'alarm off', 'recovery', 'drive'];  // Reports find the first three, and do not list the last.

const eventsOf = (events) => events.filter(({kind}) => !kNotOfTheRun.includes(kind))
  .map(({time, kind, detail, localizer}) => `${time.toFixed(3)} ${kind} ${detail} ${localizer}`);

/** Columns over the scans, for comparison. */
function columnsOf({time, torn, truth, localizers}, errors, states) {
  const poses = (name, {known, x, y, yaw}) => [[`${name} known`, known], [`${name} x`, x], [`${name} y`, y], [`${name} yaw`, yaw]];
  return new Map([['time', time], ['torn', torn], ...poses('truth', truth), ...localizers.flatMap((localizer, k) => [
    ...poses(localizer.name, localizer), ...['lost', 'quality', 'probability', 'sigma', 'populations', 'particles'].map(
      (part) => [`${localizer.name} ${part}`, localizer[part]]),
    [`${localizer.name} error`, errors[k].position], [`${localizer.name} yaw error`, errors[k].yaw], [`${localizer.name} state`, states[k]]])]);
}

/** What the page holds: {columns, events}. */
export async function heldByPage(browser) {
  const held = await browser.evaluate(`(({recording: {time, torn, truth, localizers, errors, states}, log}) =>
    ({time, torn, truth, localizers, errors, states, events: log.events}))(document.getElementById('castaway-live').view)`);
  return {columns: columnsOf(held, held.errors, held.states), events: eventsOf(held.events)};
}

/** What the report of a run's folder holds: the same. */
export function heldByReport(folder) {
  const recording = new Recording(gunzipSync(readFileSync(join(folder, 'recording.gz'))));
  const [, json] = readFileSync(join(folder, 'report.html'), 'utf8').match(/id="castaway-page"[^>]*>(.*?)<\/script>/s);
  const page = JSON.parse(json);
  const errors = recording.localizers.map((localizer) => errorsOf(recording, localizer));
  const states = recording.localizers.map((localizer, k) => statesOf(localizer, errors[k], page.right_m, page.right_rad));
  return {columns: columnsOf(recording, errors, states), events: eventsOf(page.events)};
}

/** Plays a saved session again: `castaway run` of a scenario, `castaway replay` of a log. Returns its folder. */
function playAgain(program, file, folder) {
  const out = mkdtempSync(join(folder, 'again-'));
  const command = /^log:/m.test(readFileSync(file, 'utf8')) ? ['replay', file, '--no-pictures'] : ['run', file, '--allow-programs', '--set', 'outputs.snapshots=false'];
  execFileSync(program, [...command, '--out', join(out, 'run')]);
  return join(out, 'run');
}

/** Saves the run by the page's button, and plays it again. Returns the folder of its report. */
export async function saveAndPlayAgain(page, program, folder, name) {
  const downloads = mkdtempSync(join(folder, 'saved-'));
  await page.browser.send('Page.setDownloadBehavior', {behavior: 'allow', downloadPath: downloads});
  await page.press('Save as scenario');
  const file = join(downloads, name);
  for (let tries = 0; tries < 200 && !existsSync(file); ++tries) await new Promise((resolve) => setTimeout(resolve, 50));
  return playAgain(program, file, folder);
}

/** The page holds what the report holds, scan by scan; the report may have heard of one scan more. */
export function assertSame(page, report) {
  const scans = page.columns.get('time').length;
  const more = report.columns.get('time').length - scans;
  assert.ok(more === 0 || more === 1, `${scans} scans on the page, ${more} more in the report`);
  for (const [name, column] of page.columns) {
    const other = report.columns.get(name);
    const wrong = Array.from(column).findIndex((value, i) => (value === null || other[i] === null ? value !== other[i] : !(Math.abs(value - other[i]) < 3e-3)));
    assert.equal(wrong, -1, `${name} at ${page.columns.get('time')[wrong]} s: ${column[wrong]} on the page, ${other[wrong]} in the report`);
  }
  assert.deepEqual(page.events, report.events);
}
