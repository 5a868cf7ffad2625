// How smoothly a report scrubs: node web/test/browser/scrub.mjs REPORT.html [CHROMIUM]
// Time between frames, time until the script has drawn one, CPU time of the page's thread.
import {resolve} from 'node:path';
import {pathToFileURL} from 'node:url';
import {Chromium} from './chromium.mjs';

const [page, program = 'chromium'] = process.argv.slice(2);
const browser = await Chromium.start(program);
const begin = performance.now();
await browser.open(pathToFileURL(resolve(page)).href);
await browser.until("document.querySelector('#castaway-player[data-time]')");
console.log(`ready after ${Math.round(performance.now() - begin)} ms`);
await browser.send('Performance.enable', {timeDomain: 'threadTicks'});
const cpu = async () => {
  const {metrics} = await browser.send('Performance.getMetrics');
  return 1000 * metrics.find(({name}) => name === 'TaskDuration').value;
};
const cpuBefore = await cpu();
const frames = await browser.evaluate(`(async () => {
  const slider = document.querySelector('.timeline input');
  const frame = () => new Promise((resolve) => requestAnimationFrame(resolve));
  const between = [];
  const drawing = [];
  for (let i = 0, last = await frame(); i < 300; ++i) {
    slider.value = (slider.max * i) / 300;
    slider.dispatchEvent(new Event('input'));
    const now = await frame();  // Asked for after the player's own, so called after it has drawn.
    drawing.push(performance.now() - now);
    between.push(now - last);
    last = now;
  }
  return {between, drawing};
})()`);
for (const [what, times] of Object.entries(frames)) {
  times.sort((a, b) => a - b);
  const at = (share) => `${times[Math.floor(share * (times.length - 1))].toFixed(1)} ms`;
  console.log(`300 frames, ${what}: median ${at(0.5)}, 95 % below ${at(0.95)}, longest ${at(1)}`);
}
console.log(`CPU time of the page's thread: ${((await cpu() - cpuBefore) / 300).toFixed(1)} ms a frame`);
await browser.close();
