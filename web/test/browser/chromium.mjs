// Chromium without a window, spoken to over a pipe (its DevTools protocol).
import {spawn} from 'node:child_process';
import {mkdtempSync, rmSync} from 'node:fs';
import {tmpdir} from 'node:os';
import {join} from 'node:path';

const kFlags = ['--headless=new', '--no-sandbox', '--disable-gpu', '--enable-unsafe-swiftshader', '--no-first-run', '--hide-scrollbars',
  '--disable-extensions', '--disable-background-networking', '--remote-debugging-pipe', 'about:blank'];

/** A browser with one page. Errors of the page's console and scripts gather in `errors`. */
export class Chromium {
  static async start(program) {
    const browser = new Chromium();
    browser.profile = mkdtempSync(join(tmpdir(), 'castaway-chromium-'));
    browser.process = spawn(program, [`--user-data-dir=${browser.profile}`, ...kFlags],
      {stdio: ['ignore', 'ignore', 'ignore', 'pipe', 'pipe']});
    browser.process.stdio[4].on('data', (data) => browser.receive(data));
    const {targetInfos} = await browser.send('Target.getTargets');
    const {targetId} = targetInfos.find(({type}) => type === 'page');
    const {sessionId} = await browser.send('Target.attachToTarget', {targetId, flatten: true});
    browser.session = sessionId;
    for (const domain of ['Page', 'Runtime', 'Log', 'Network']) await browser.send(`${domain}.enable`);
    return browser;
  }

  constructor() {
    this.last = 0;
    this.waiting = new Map();
    this.rest = Buffer.alloc(0);
    this.errors = [];
    this.requests = [];
  }

  send(method, params = {}) {
    const id = ++this.last;
    const message = {id, method, params, ...(this.session ? {sessionId: this.session} : {})};
    this.process.stdio[3].write(`${JSON.stringify(message)}\0`);
    return new Promise((resolve, reject) => this.waiting.set(id, {resolve, reject, method}));
  }

  receive(data) {
    this.rest = Buffer.concat([this.rest, data]);
    for (let end = this.rest.indexOf(0); end >= 0; end = this.rest.indexOf(0)) {
      this.take(JSON.parse(this.rest.subarray(0, end).toString()));
      this.rest = this.rest.subarray(end + 1);
    }
  }

  take({id, result, error, method, params}) {
    if (id) {
      const {resolve, reject, method: asked} = this.waiting.get(id);
      this.waiting.delete(id);
      if (error) reject(new Error(`${asked}: ${error.message}`));
      else resolve(result);
    } else if (method === 'Runtime.exceptionThrown') {
      this.errors.push(params.exceptionDetails.exception?.description ?? params.exceptionDetails.text);
    } else if (method === 'Runtime.consoleAPICalled' && ['error', 'warning'].includes(params.type)) {
      this.errors.push(params.args.map((arg) => arg.value ?? arg.description).join(' '));
    } else if (method === 'Log.entryAdded' && params.entry.level === 'error') {
      this.errors.push(params.entry.text);
    } else if (method === 'Network.requestWillBeSent') {
      this.requests.push(params.request.url);
    }
  }

  /** The value of an expression in the page; of a promise, what it leads to. */
  async evaluate(expression) {
    const {result, exceptionDetails} = await this.send('Runtime.evaluate',
      {expression, awaitPromise: true, returnByValue: true});
    if (exceptionDetails) {
      throw new Error(exceptionDetails.exception?.description ?? exceptionDetails.text);
    }
    return result.value;
  }

  /** Until the expression is true; throws after a minute. */
  async until(expression) {
    for (let tries = 0; tries < 1200; ++tries) {
      if (await this.evaluate(`Boolean(${expression})`)) return;
      await new Promise((resolve) => setTimeout(resolve, 50));
    }
    throw new Error(`never came true: ${expression}; errors: ${this.errors.join('; ')}`);
  }

  /** Opens a page in a window of this size, in these colours. */
  async open(url, {width = 1280, height = 900, dark = false, mobile = false} = {}) {
    await this.send('Emulation.setDeviceMetricsOverride', {width, height, deviceScaleFactor: 1, mobile});
    await this.send('Emulation.setEmulatedMedia',
      {features: [{name: 'prefers-color-scheme', value: dark ? 'dark' : 'light'}]});
    await this.send('Page.navigate', {url});
    await this.until(`location.href === ${JSON.stringify(url)} && document.readyState === 'complete'`);
  }

  async key(key, code = key, modifiers = 0) {
    const text = key.length === 1 ? {text: key} : key === 'Enter' ? {text: '\r'} : {};
    const keys = {Tab: 9, Enter: 13, Escape: 27, Home: 36, End: 35, ArrowLeft: 37, ArrowUp: 38, ArrowRight: 39, ArrowDown: 40, ' ': 32};
    const common = {key, code, modifiers, windowsVirtualKeyCode: keys[key] ?? key.charCodeAt(0)};
    await this.send('Input.dispatchKeyEvent', {type: 'keyDown', ...common, ...text});
    await this.send('Input.dispatchKeyEvent', {type: 'keyUp', ...common});
  }

  /** Presses at a point, moves through the others, lets go at the last. */
  async drag(points) {
    const mouse = (type, [x, y]) =>
      this.send('Input.dispatchMouseEvent', {type, x, y, button: 'left', buttons: 1, clickCount: 1});
    await mouse('mousePressed', points[0]);
    for (const point of points.slice(1)) await mouse('mouseMoved', point);
    await mouse('mouseReleased', points.at(-1));
  }

  /** Fingers on the screen, one list of points a moment; they leave it after the last. */
  async touch(moments) {
    await this.send('Emulation.setTouchEmulationEnabled', {enabled: true, maxTouchPoints: 2});
    const touch = (type, points) =>
      this.send('Input.dispatchTouchEvent', {type, touchPoints: points.map(([x, y], id) => ({x, y, id}))});
    await touch('touchStart', moments[0]);
    for (const points of moments.slice(1)) await touch('touchMove', points);
    await touch('touchEnd', []);
    await this.send('Emulation.setTouchEmulationEnabled', {enabled: false});
  }

  /** A PNG of the window, or of the whole page. */
  async screenshot(whole = false) {
    const {data} = await this.send('Page.captureScreenshot', {format: 'png', captureBeyondViewport: whole});
    return Buffer.from(data, 'base64');
  }

  async close() {
    const ended = new Promise((resolve) => this.process.once('exit', resolve));
    this.session = undefined;
    this.send('Browser.close').catch(() => {});
    const timer = setTimeout(() => this.process.kill('SIGKILL'), 5000);
    await ended;
    clearTimeout(timer);
    rmSync(this.profile, {recursive: true, force: true, maxRetries: 5});
  }
}
