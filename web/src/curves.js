// Curves over time by uPlot: one zoom and one cursor for all, marks of events, the player's time.
import uPlot from 'uplot';
import {element} from './dom.js';
import {kDashes, pick} from './palette.js';
import {drawAlarms, drawLimit, drawMarks} from './plot_marks.js';

const kHeight = 190;  // [px]
const kLeft = 58;
const kLegendLines = ['solid', 'dashed', 'dotted', 'double', 'dashed', 'dotted'];

/** What is plotted; `of`: (localizer, errors) -> values over the scans. */
export const kCurves = [
  {title: 'Position error', unit: 'm', log: [0.001, 100], limit: 'rightM', of: (_, e) => e.position},
  {title: 'Yaw error', unit: '°', log: [0.01, 180], limit: 'rightDeg',
    of: (_, e) => e.yaw.map((v) => (v === null ? null : (v * 180) / Math.PI))},
  {title: 'Quality: how well the scan fits the map', unit: '0 to 1', range: [0, 1],
    of: (l) => answered(l, l.quality)},
  {title: 'Stated probability that the pose is right', unit: '0 to 1', range: [0, 1],
    of: (l) => answered(l, l.probability)},
  {title: 'Uncertainty: standard deviation of the position', unit: 'm', log: [0.001, 100],
    of: (l) => answered(l, l.sigma)},
  {title: 'Hypotheses: populations of particles', unit: 'count', of: (l) => Array.from(l.populations)},
];

/** Nothing where the localizer has no answer. */
function answered(localizer, values) {
  return Array.from(values, (value, i) => (localizer.known[i] ? value : null));
}

/** Log axes take no zero. */
function clipped(values, [low, high]) {
  return values.map((v) => (v === null ? null : Math.min(high, Math.max(low, v))));
}

function logRange(columns, [low, high]) {
  let least = Infinity;
  let most = low;
  for (const values of columns) {
    for (const value of values) {
      if (value === null) continue;
      least = Math.min(least, value);
      most = Math.max(most, value);
    }
  }
  const floor = 10 ** Math.floor(Math.log10(Math.max(low, Math.min(least, 1))));
  return [Math.min(floor, 0.1), Math.min(high, Math.max(1, 10 ** Math.ceil(Math.log10(most))))];
}

/** All plots of a run. `seek(time)` is called where a reader clicks. */
export class Curves {
  constructor(place, run, marks, colors, seek) {
    this.place = place;
    this.run = run;
    this.marks = marks.filter((mark) => mark.sort !== 'driving');
    this.colors = colors;
    this.seek = seek;
    this.plots = [];
    this.sync = uPlot.sync('castaway');
    for (const curve of kCurves) this.add(curve);
    new ResizeObserver(() => this.resize()).observe(place);
  }

  add(curve) {
    const {recording, errors} = this.run;
    let columns = recording.localizers.map((l, k) => curve.of(l, errors[k]));
    if (curve.log) columns = columns.map((values) => clipped(values, curve.log));
    const figure = element('figure', {class: 'curve'},
      element('figcaption', {}, `${curve.title} `, element('span', {class: 'unit'}, `[${curve.unit}]`)));
    this.place.append(figure);
    const plot = new uPlot(this.options(curve, columns), [Array.from(recording.time), ...columns], figure);
    const head = element('div', {class: 'playhead'});
    plot.over.append(head);
    this.linkZoom(plot);
    plot.over.addEventListener('click', (event) => this.click(plot, event));
    this.plots.push({plot, head});
  }

  options(curve, columns) {
    const {recording} = this.run;
    const axis = {stroke: () => this.colors().soft, font: '12px system-ui, sans-serif',
      grid: {stroke: () => this.colors().line, width: 1},
      ticks: {stroke: () => this.colors().line, width: 1, size: 4}};
    const range = curve.log ? logRange(columns, curve.log) : curve.range;
    return {
      width: this.width(), height: kHeight,
      scales: {
        x: {time: false},
        y: curve.log ? {distr: 3, range} : {range: range ?? ((_, low, high) => [0, Math.max(2, high + 1)])},
      },
      axes: [
        {...axis, label: 'time [s]', labelSize: 16, labelFont: '12px system-ui, sans-serif', size: 30},
        {...axis, size: kLeft, ...(curve.log ? powersOfTen : {})},
      ],
      series: [
        {label: 'time', value: (_, v) => (v === null ? '–' : `${v.toFixed(2)} s`)},
        ...recording.names.map((label, k) => ({
          label, scale: 'y', width: 1.8, dash: pick(kDashes, k), points: {show: false}, spanGaps: false,
          stroke: () => pick(this.colors().localizers, k),
          value: (_, v) => (v === null || v === undefined ? '–' : v.toFixed(v < 1 ? 3 : 2)),
        })),
      ],
      cursor: {sync: {key: 'castaway', setSeries: false}, drag: {x: true, y: false}, points: {size: 7}},
      legend: {markers: {width: 3, dash: (_, i) => pick(kLegendLines, i - 1)}},
      hooks: {draw: [(plot) => {
        drawMarks(plot, this.marks, this.colors());
        drawAlarms(plot, this.run.alarms, this.colors());
        if (curve.limit) drawLimit(plot, this.run.limits[curve.limit], this.colors());
      }]},
    };
  }

  /** All plots show the stretch of time that one was zoomed to. */
  linkZoom(plot) {
    plot.hooks.setScale = [(source, key) => {
      if (key !== 'x' || this.linking) return;
      this.linking = true;
      const {min, max} = source.scales.x;
      for (const other of this.plots) if (other.plot !== source) other.plot.setScale('x', {min, max});
      this.linking = false;
      requestAnimationFrame(() => this.show(this.time ?? 0));
    }];
  }

  /** A click, not the end of a drag. */
  click(plot, event) {
    if (plot.select.width > 0) return;
    const box = plot.over.getBoundingClientRect();
    this.seek(plot.posToVal(event.clientX - box.left, 'x'));
  }

  /** The player is at `time`, which is scan `scan`. */
  show(time, scan = this.scan) {
    this.time = time;
    this.scan = scan;
    for (const {plot, head} of this.plots) {
      const x = plot.valToPos(time, 'x');
      // Of bbox: to ask the element for its width would lay the page out anew for every plot.
      head.hidden = !(x >= 0 && x <= plot.bbox.width / devicePixelRatio);
      head.style.transform = `translateX(${x.toFixed(1)}px)`;
      if (scan !== undefined && plot.cursor.left < 0) plot.setLegend({idx: scan}, false);
    }
  }

  /** Of a plot within its border. [px] */
  width() {
    return Math.max(260, this.place.clientWidth - 2);
  }

  resetZoom() {
    const {time} = this.run.recording;
    this.plots[0]?.plot.setScale('x', {min: time[0], max: time.at(-1)});
  }

  resize() {
    const width = this.width();
    for (const {plot} of this.plots) if (plot.width !== width) plot.setSize({width, height: kHeight});
    if (this.time !== undefined) this.show(this.time);
  }

  redraw() {
    for (const {plot} of this.plots) plot.redraw(false, true);
  }
}

/** Ticks of a log axis: powers of ten and nothing between. */
const powersOfTen = {
  splits: (_, __, low, high) => {
    const ticks = [];
    for (let power = Math.ceil(Math.log10(low) - 1e-6); 10 ** power <= high * 1.000001; ++power) {
      ticks.push(10 ** power);
    }
    return ticks;
  },
  filter: (_, ticks) => ticks,
  values: (_, ticks) => ticks.map((tick) => String(Number(tick.toPrecision(1)))),
};
