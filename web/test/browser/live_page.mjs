// What a reader does on the page of a live run, by the browser that shows it.
import {toScreen} from '../../src/view.js';

export const kTime = `Number(document.getElementById('castaway-live').dataset.time ?? 0)`;

/** Time of the run, whatever is looked at. */
export const kNow = `document.getElementById('castaway-live').view.now`;

const kButton = `document.querySelector('#castaway-live .play').textContent`;

export class LivePage {
  constructor(browser) {
    this.browser = browser;
  }

  /** Presses the button with this text, once there is one. */
  async press(text) {
    const button = `[...document.querySelectorAll('#castaway-live button')]
      .find((button) => button.textContent === ${JSON.stringify(text)})`;
    await this.browser.until(`${button} && !${button}.hidden`);
    await this.browser.evaluate(`${button}.click()`);
  }

  /** Until the run plays, as the page knows, too: a moment later. */
  async play() {
    await this.press('Play');
    await this.browser.until(`${kButton} === 'Pause'`);
  }

  /** Until the run stands still. */
  async pause() {
    if (await this.browser.evaluate(kButton) === 'Pause') await this.press('Pause');
    await this.browser.until(`${kButton} === 'Play'`);
  }

  /** Until the run has played so far that this is true. */
  async playUntil(expression) {
    await this.play();
    await this.browser.until(expression);
    await this.pause();
  }

  /** Simulated seconds per second. */
  setSpeed(speed) {
    return this.browser.evaluate(`(() => {
      const speed = document.querySelector('#castaway-live [aria-label="Speed"]');
      speed.value = '${speed}';
      speed.dispatchEvent(new Event('change'));
    })()`);
  }

  /** To the next scan. */
  async step() {
    const before = await this.browser.evaluate(kNow);
    await this.press('Step a scan');
    await this.browser.until(`${kNow} > ${before}`);
  }

  /** Looks at a time [s] of the past. */
  look(time) {
    return this.browser.evaluate(`(() => {
      const slider = document.querySelector('#castaway-live [aria-label="Time"]');
      slider.value = ${time};
      slider.dispatchEvent(new Event('input'));
    })()`);
  }

  /** Until the run has gone back to a time [s]. */
  async goBack(time) {
    await this.look(time);
    await this.press('Go on from here');
    await this.browser.until(`${kNow} < ${time + 0.5}`);
  }

  /** The point of the window where the map shows a point of the frame map. */
  async onScreen(x, y) {
    const [left, top, view] = await this.browser.evaluate(`(() => {
      const box = document.querySelector('canvas.map').getBoundingClientRect();
      return [box.left, box.top, JSON.parse(document.getElementById('castaway-live').dataset.view)];
    })()`);
    const [px, py] = toScreen(view, x, y);
    return [left + px, top + py];
  }

  /** The true pose that the page shows. */
  truth() {
    return this.browser.evaluate(`JSON.parse(document.getElementById('castaway-live').dataset.truth)`);
  }

  /** Until something like this happened. */
  logged(word) {
    return this.browser.until(
      `[...document.querySelectorAll('.log li')].some((li) => li.textContent.includes(${JSON.stringify(word)}))`);
  }

  /** Until the page says this. */
  noted(word) {
    return this.browser.until(
      `document.querySelector('#castaway-live .note').textContent.includes(${JSON.stringify(word)})`);
  }

  /** Chooses files, by name with their texts, by the page's button. */
  choose(files) {
    return this.browser.evaluate(`(() => {
      const files = new DataTransfer();
      for (const [path, text] of ${JSON.stringify(Object.entries(files))}) {
        const file = new File([text], path.split('/').at(-1));
        Object.defineProperty(file, 'webkitRelativePath', {value: path.includes('/') ? path : ''});
        files.items.add(file);
      }
      const input = document.querySelector('#castaway-live input[type=file]');
      input.files = files.files;
      input.dispatchEvent(new Event('change'));
    })()`);
  }
}
