// Films a page while a hand, which is drawn into it, moves over it.
import {readFileSync, writeFileSync} from 'node:fs';
import {join} from 'node:path';

const kPeriod = 100;  // [ms] Of a frame, if the computer is fast enough.
const kStep = 150;  // [px] The hand moves between two frames.
const kLongest = 200;  // [ms] A frame is shown, however long the computer took for it.
const kLast = 1200;  // [ms] The last frame is shown.
const kPatience = 30;  // [s]

/** The hand: an arrow that lies over the page and takes no events. */
const kHand = `(() => {
  document.body.insertAdjacentHTML('beforeend', '<svg id="film-hand" width="26" height="32" viewBox="0 0 13 16"><path ' +
    'd="M1 1v12l3-3 2 5 2-1-2-5h4z" fill="#fff" stroke="#000" stroke-linejoin="round"/></svg>');
  const {style} = document.getElementById('film-hand');
  Object.assign(style, {position: 'fixed', width: 'auto', border: 0, background: 'none', borderRadius: 0,
    pointerEvents: 'none', zIndex: 99, filter: 'drop-shadow(0 0 2px #0008)'});
})()`;

export class Film {
  constructor(browser, folder) {
    this.browser = browser;
    this.folder = folder;
    this.frames = [];  // {name, at: ms}
    this.down = false;
  }

  async begin(at) {
    await this.browser.evaluate(kHand);
    await this.place(at);
    await this.shoot();
  }

  mouse(type) {
    const [x, y] = this.at;
    return this.browser.send('Input.dispatchMouseEvent',
      {type, x, y, button: this.down || type !== 'mouseMoved' ? 'left' : 'none', buttons: this.down ? 1 : 0, clickCount: 1});
  }

  async place(at) {
    this.at = at;
    await this.browser.evaluate(`Object.assign(document.getElementById('film-hand').style,
      {left: '${at[0] - 2}px', top: '${at[1] - 2}px'})`);
    await this.mouse('mouseMoved');
  }

  /** Moves the hand to a point, a frame a step: slower at its ends. */
  async moveTo([x, y]) {
    const [x0, y0] = this.at;
    const steps = Math.max(2, Math.round(Math.hypot(x - x0, y - y0) / kStep));
    for (let i = 1; i <= steps; ++i) {
      const share = (1 - Math.cos((Math.PI * i) / steps)) / 2;
      await this.place([x0 + share * (x - x0), y0 + share * (y - y0)]);
      await this.shoot();
    }
  }

  async press() {
    this.down = true;
    await this.mouse('mousePressed');
  }

  async release() {
    await this.mouse('mouseReleased');
    this.down = false;
    await this.shoot();
  }

  async click(at) {
    await this.moveTo(at);
    await this.press();
    await this.release();
  }

  /** Takes a frame, when it is time for one. */
  async shoot() {
    const last = this.frames.at(-1)?.at ?? -Infinity;
    const rest = last + kPeriod - performance.now();
    if (rest > 0) await new Promise((resolve) => setTimeout(resolve, rest));
    const at = performance.now();
    const name = `${String(this.frames.length).padStart(4, '0')}.png`;
    writeFileSync(join(this.folder, name), await this.browser.screenshot());
    this.frames.push({name, at});
  }

  async roll(seconds) {
    for (const end = performance.now() + 1000 * seconds; performance.now() < end;) await this.shoot();
  }

  async until(expression) {
    const end = performance.now() + 1000 * kPatience;
    while (!(await this.browser.evaluate(`Boolean(${expression})`))) {
      if (performance.now() > end) throw new Error(`never came true: ${expression}`);
      await this.shoot();
    }
    await this.shoot();
  }

  /** Makes the pictures smaller, in the browser: Chromium takes no exact input while it shows a page at another scale. */
  async shrink(scale) {
    await this.browser.open('about:blank');
    for (const {name} of this.frames) {
      const file = join(this.folder, name);
      const smaller = await this.browser.evaluate(`(async () => {
        const picture = new Image();
        picture.src = 'data:image/png;base64,${readFileSync(file, 'base64')}';
        await picture.decode();
        const canvas = new OffscreenCanvas(${scale} * picture.width, ${scale} * picture.height);
        const context = canvas.getContext('2d');
        context.imageSmoothingQuality = 'high';
        context.drawImage(picture, 0, 0, canvas.width, canvas.height);
        const bytes = new Uint8Array(await (await canvas.convertToBlob()).arrayBuffer());
        return btoa(Array.from(bytes, (byte) => String.fromCharCode(byte)).join(''));
      })()`);
      writeFileSync(file, Buffer.from(smaller, 'base64'));
    }
  }

  /** How long frame `i` is shown. [ms] */
  shown(i) {
    const next = this.frames[i + 1];
    return next ? Math.min(kLongest, Math.round(next.at - this.frames[i].at)) : kLast;
  }

  /** Frames with the time that each is shown, as img2webp takes them. */
  sheet() {
    return this.frames.map(({name}, i) => `-d ${this.shown(i)} ${name}\n`).join('');
  }

  summary() {
    const shown = this.frames.reduce((sum, _, i) => sum + this.shown(i), 0);
    return `${this.frames.length} frames, ${(shown / 1000).toFixed(1)} s`;
  }
}
