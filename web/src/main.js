// Starts the player of a report.
import 'uplot/dist/uPlot.min.css';
import './player.css';
import './plots.css';
import './view3d/view3d.css';
import {fromBase64, gunzip} from './bytes.js';
import {curvesCsv} from './curve_rows.js';
import {element} from './dom.js';
import {hashTime, openingTime} from './hash_time.js';
import {errorsOf, statesOf, stretches} from './measures.js';
import {Player} from './player.js';
import {drawPlots} from './plots.js';
import {Recording} from './recording.js';
import {save, saveCanvases} from './saving.js';
import {addThemeSwitch} from './theme.js';

/** The text of an element of the page; null where there is none. */
function textOf(id) {
  return document.getElementById(id)?.textContent ?? null;
}

/** What can be seen in three dimensions; null where the recording does not say. */
function sceneOf(recording) {
  const bytes = recording.sections.get('scene');
  return bytes ? JSON.parse(new TextDecoder().decode(bytes)) : null;
}

/** All that the player shows, parsed from the page. */
async function load() {
  const page = JSON.parse(textOf('castaway-page'));
  const recording = new Recording(await gunzip(fromBase64(textOf('castaway-recording').trim())));
  const errors = recording.localizers.map((localizer) => errorsOf(recording, localizer));
  const states = recording.localizers.map((localizer, k) =>
    statesOf(localizer, errors[k], page.right_m, page.right_rad));
  const alarms = recording.localizers.map(({lost}) =>
    stretches(Array.from(lost), recording.time, recording.time.at(-1)).filter(({state}) => state === 1));
  const limits = {rightM: page.right_m, rightDeg: (page.right_rad * 180) / Math.PI};
  return {recording, errors, states, alarms, limits, events: page.events, open: page.open_s ?? null, scene: sceneOf(recording)};
}

/** Buttons that save curves and pictures. */
function savers(player, run) {
  const name = `${run.recording.header.scenario}-seed-${run.recording.header.seed}`;
  const button = (text, act) => element('button', {type: 'button', click: act}, text);
  return [
    button('Curves as CSV', () => save(`${name}-curves.csv`, curvesCsv(run), 'text/csv')),
    button('Curves as SVG', () => save(`${name}-curves.svg`, player.curves.svg(), 'image/svg+xml')),
    button('Curves as PNG', () => saveCanvases(`${name}-curves.png`, player.curves.canvases(), player.colors.page)),
    button('Map as PNG', () => saveCanvases(`${name}-map.png`, [player.views.shown], player.colors.page)),
  ];
}

/** Makes the times in the table of events jump the player there. */
function linkRows(player) {
  for (const row of document.querySelectorAll('tr[data-time]')) {
    const time = Number(row.dataset.time);
    const cell = row.cells[0];
    cell.replaceChildren(element('button', {type: 'button', class: 'jump', click: () => {
      player.act('seek', time);
      player.place.scrollIntoView({block: 'start'});
    }}, cell.textContent));
  }
}

/** When and where the run was made also stands at the head: it is written among the times, which differ in every repetition. */
function showMade() {
  const made = document.getElementById('castaway-made');
  const place = document.getElementById('castaway-made-place');
  if (made && place) place.textContent = `, ${made.textContent}`;
}

async function start() {
  showMade();
  const recolorPlots = drawPlots();
  let recolor = () => {};
  addThemeSwitch(document.getElementById('castaway-theme-place') ?? document.body, () => {
    recolorPlots();
    recolor();
  });
  const place = document.getElementById('castaway-player');
  if (!place || textOf('castaway-recording') === null) return;
  try {
    const run = await load();
    const curves = document.getElementById('castaway-curves');
    for (const live of document.querySelectorAll('.live')) live.hidden = false;
    const player = new Player(place, curves, run);
    const zoom = document.getElementById('castaway-zoom');
    zoom?.addEventListener('click', () => player.curves.resetZoom());
    zoom?.before(...savers(player, run));
    recolor = () => player.recolor();
    linkRows(player);
    const asked = hashTime(location.hash) ?? openingTime(run.open, run.recording.time);
    if (asked !== null) player.act('seek', asked);
    addEventListener('hashchange', () => {
      const time = hashTime(location.hash);
      if (time !== null) player.act('seek', time);
    });
    place.dataset.ready = 'true';
  } catch (error) {
    for (const live of document.querySelectorAll('.live')) live.hidden = true;
    place.hidden = false;
    place.replaceChildren(element('p', {role: 'alert'}, `The player cannot start: ${error.message}`));
    console.error(error);
  }
}

start();
