// Curves over time by uPlot: one zoom and one cursor for all, marks of events, the player's time.
import uPlot from 'uplot';
import {element} from './dom.js';
import {hasTruth} from './measures.js';
import {stylesOf} from './palette.js';
import {addPlot, widthIn} from './plot.js';
import {drawAlarms, drawMarks} from './plot_marks.js';
import {plotsSvg} from './plot_svg.js';

const kHeight = 190;  // [px]

/** What is plotted; `of`: (localizer, errors) -> values over the scans. Where it is `scored`, it takes the truth. */
export const kCurves = [
  {title: 'Position error', unit: 'm', log: [0.001, 100], limit: 'rightM', scored: true, of: (_, e) => e.position},
  {title: 'Yaw error', unit: '°', log: [0.01, 180], limit: 'rightDeg', scored: true,
    of: (_, e) => e.yaw.map((v) => (v === null ? null : (v * 180) / Math.PI))},
  {title: 'Quality: how well the scan fits the map', unit: '0 to 1', range: [0, 1],
    of: (l) => answered(l, l.quality)},
  {title: 'Stated probability that the pose is right', unit: '0 to 1', range: [0, 1],
    of: (l) => answered(l, l.probability)},
  {title: 'Uncertainty: standard deviation of the position', unit: 'm', log: [0.001, 100],
    of: (l) => answered(l, l.sigma)},
  {title: 'Hypotheses: populations of particles', unit: 'count', of: (l) => Array.from(l.populations)},
].map((curve) => ({...curve, localizers: true}));

/** Nothing where the localizer has no answer, or does not state the value. */
function answered(localizer, values) {
  return Array.from(values, (value, i) => (localizer.known[i] && value >= 0 ? value : null));
}

/** All plots of a run, the first one in a place of its own. `seek(time)` is called where a reader clicks. */
export class Curves {
  constructor(firstPlace, place, run, marks, colors, seek) {
    this.place = place;
    this.run = run;
    this.marks = marks.filter((mark) => mark.sort !== 'driving');
    this.colors = colors;
    this.seek = seek;
    this.plots = [];
    this.sync = uPlot.sync('castaway');
    const truth = hasTruth(run.recording);
    kCurves.filter(({scored}) => truth || !scored)
      .forEach((curve, i) => this.add(i === 0 ? firstPlace : place, curve));
    new ResizeObserver(() => this.resize()).observe(place);
  }

  add(place, curve) {
    const {recording, errors, limits} = this.run;
    const plot = addPlot(place, {
      ...curve, x: {label: 'time [s]'}, y: {log: curve.log, range: curve.range, least: 2},
      shared: Array.from(recording.time), limit: limits[curve.limit],
      series: recording.localizers.map((localizer, k) =>
        ({name: recording.names[k], y: curve.of(localizer, errors[k])})),
    }, kHeight, this.colors, {
      cursor: {sync: {key: 'castaway', setSeries: false}},
      draw: (drawn) => this.draw(drawn),
    });
    const head = element('div', {class: 'playhead'});
    plot.over.append(head);
    this.linkZoom(plot);
    plot.over.addEventListener('click', (event) => this.click(plot, event));
    this.plots.push({plot, head, curve});
  }

  draw(plot) {
    drawMarks(plot, this.marks, this.colors());
    drawAlarms(plot, this.run.alarms, this.colors(), stylesOf(this.run.recording.names));
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

  /** All plots, as they are drawn now, as vector graphics. */
  svg() {
    const {recording, limits} = this.run;
    const styles = stylesOf(recording.names);
    return plotsSvg(this.plots.map(({plot, curve}) => ({plot, title: curve.title, unit: curve.unit, styles,
      marks: this.marks, limit: limits[curve.limit]})), recording.names, this.colors());
  }

  /** All plots, as they are drawn now. */
  canvases() {
    return this.plots.map(({plot}) => plot.ctx.canvas);
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

  resetZoom() {
    const {time} = this.run.recording;
    this.plots[0]?.plot.setScale('x', {min: time[0], max: time.at(-1)});
  }

  resize() {
    for (const {plot} of this.plots) {
      const width = widthIn(plot.root.parentElement);
      if (plot.width !== width) plot.setSize({width, height: kHeight});
    }
    if (this.time !== undefined) this.show(this.time);
  }

  redraw() {
    for (const {plot} of this.plots) plot.redraw(false, true);
  }
}
