// How smoothly a report scrubs: node web/test/browser/scrub.mjs REPORT.html [CHROMIUM]
import {resolve} from 'node:path';
import {pathToFileURL} from 'node:url';
import {Chromium} from './chromium.mjs';

const [page, program = 'chromium'] = process.argv.slice(2);
const browser = await Chromium.start(program);
const begin = performance.now();
await browser.open(pathToFileURL(resolve(page)).href);
await browser.until("document.querySelector('#castaway-player[data-time]')");
console.log(`ready after ${Math.round(performance.now() - begin)} ms`);
const frames = await browser.evaluate(`(async () => {
  const slider = document.querySelector('.timeline input');
  const frame = () => new Promise((resolve) => requestAnimationFrame(resolve));
  const times = [];
  for (let i = 0, last = await frame(); i < 300; ++i) {
    slider.value = (slider.max * i) / 300;
    slider.dispatchEvent(new Event('input'));
    const now = await frame();
    times.push(now - last);
    last = now;
  }
  return times.sort((a, b) => a - b);
})()`);
const at = (share) => frames[Math.floor(share * (frames.length - 1))].toFixed(1);
console.log(`300 steps over the run, time between frames: median ${at(0.5)} ms, 95 % below ${at(0.95)} ms, ` +
  `longest ${at(1)} ms`);
await browser.close();
