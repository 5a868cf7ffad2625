// A curve over the last minutes of a live run; which one is chosen above it.
import 'uplot/dist/uPlot.min.css';
import './plots.css';
import {kCurves} from './curves.js';
import {element} from './dom.js';
import {kLimits} from './live_recording.js';
import {addPlot, widthIn} from './plot.js';
import {clip} from './plot_columns.js';

const kHeight = 125;  // [px]
const kWindows = [[30, '30 s'], [120, '2 min'], [600, '10 min'], [1e9, 'all']];

/** uPlot's columns of a curve from `from` on: times, then the values of each localizer. */
export function columnsOf(curve, recording, from) {
  const first = recording.time.findIndex((time) => time >= from);
  const begin = first < 0 ? recording.scans : first;
  return [recording.time.slice(begin), ...recording.localizers.map((localizer, k) => {
    const part = {...localizer};
    for (const [name, values] of Object.entries(localizer)) if (Array.isArray(values)) part[name] = values.slice(begin);
    const errors = recording.errors[k];
    const values = curve.of(part, {position: errors.position.slice(begin), yaw: errors.yaw.slice(begin)});
    return curve.log ? clip(values, curve.log) : values;
  })];
}

export class LiveCurve {
  /** `seek(time)`: a reader clicked there. */
  constructor(place, recording, colors, seek) {
    this.recording = recording;
    this.colors = colors;
    this.seek = seek;
    this.curve = kCurves[0];
    this.window = 120;
    const choose = (label, entries, act) => element('select', {'aria-label': label, change: ({target}) => act(target.value)},
      ...entries.map(([value, text]) => element('option', {value, selected: value === this.window}, text)));
    this.plots = element('div', {class: 'plots'});
    place.append(element('div', {class: 'curve-head'},
      choose('Curve', kCurves.map(({title, unit}, i) => [i, unit ? `${title} [${unit}]` : title]), (i) => {
        this.curve = kCurves[Number(i)];
        this.draw();
      }),
      choose('Time shown', kWindows, (seconds) => {
        this.window = Number(seconds);
        this.update();
      })), this.plots);
    this.draw();
    new ResizeObserver(() => this.plot.setSize({width: widthIn(this.plots), height: kHeight})).observe(this.plots);
  }

  draw() {
    this.plot?.destroy();
    this.plots.replaceChildren();
    const {curve, recording} = this;
    this.plot = addPlot(this.plots, {
      ...curve, title: '', unit: null, x: {label: ''}, y: {log: curve.log, range: curve.range, least: 2}, shared: [],
      limit: kLimits[curve.limit], series: recording.names.map((name) => ({name, y: []})),
    }, kHeight, this.colors);
    this.plot.ctx.canvas.setAttribute('aria-label', curve.title);
    this.plot.over.addEventListener('click', (event) => {
      const box = this.plot.over.getBoundingClientRect();
      if (this.plot.select.width === 0) this.seek(this.plot.posToVal(event.clientX - box.left, 'x'));
    });
    this.update();
  }

  /** The recording has changed. */
  update() {
    const end = this.recording.time.at(-1) ?? 0;
    this.plot.setData(columnsOf(this.curve, this.recording, end - this.window));
  }

  recolor() {
    this.plot.redraw(false, true);
  }
}
