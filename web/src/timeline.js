// The slider of time with its marks, and a lane a localizer that says when it was right.
import {clockText, element} from './dom.js';
import {kFalseAlarm, kRight, kSaysLost, kStateWords, kUnknown, kWrong, stretches} from './measures.js';
import {pick, styleOf} from './palette.js';
import {spread} from './marks.js';

const kLane = 10;  // [px] Height of a bar...
const kRow = 27;  // [px] ...and of the row with its name above.
const kApart = 15;
const kThumb = 8;  // [px] Half the slider's thumb: its middle never comes nearer to the ends.

/** The slider and the lanes. `seek(time)` is called with every time that is chosen. */
export class Timeline {
  constructor(place, run, marks, colors, seek) {
    this.run = run;
    this.marks = marks;
    this.colors = colors;
    this.seek = seek;
    this.takeEnds();
    this.buttons = new Map();  // Of the marks that are shown, by what they say.
    this.markRow = element('div', {class: 'marks', role: 'group', 'aria-label': 'Events'});
    this.slider = element('input', {type: 'range', min: this.begin, max: this.end, step: 'any',
      value: this.begin, 'aria-label': 'Time', input: () => seek(Number(this.slider.value))});
    const names = run.recording.names.join(', ');
    this.lanes = element('canvas', {class: 'lanes', role: 'img',
      'aria-label': `When each localizer was right: ${names}`, click: (event) => this.click(event)});
    this.laneMarks = element('div', {class: 'lane-marks', role: 'group', 'aria-label': 'Recoveries'});
    place.append(this.markRow, this.slider, element('div', {class: 'lane-box'}, this.lanes, this.laneMarks));
    this.lanes.style.height = `${run.states.length * kRow}px`;
    new ResizeObserver(() => this.layOut()).observe(place);
  }

  takeEnds() {
    const {time} = this.run.recording;
    this.begin = time[0] ?? 0;
    this.end = time.at(-1) ?? 0;
  }

  /** The recording has grown, or lost some of its scans. */
  grown(marks) {
    this.takeEnds();
    this.marks = marks;
    this.slider.min = this.begin;
    this.slider.max = this.end;
    this.layOut();
  }

  x(time, width) {
    return kThumb + ((time - this.begin) / Math.max(this.end - this.begin, 1e-9)) * (width - 2 * kThumb);
  }

  click(event) {
    const share = (event.offsetX - kThumb) / (this.lanes.clientWidth - 2 * kThumb);
    this.seek(this.begin + share * (this.end - this.begin));
  }

  layOut() {
    const width = this.slider.clientWidth;
    if (!width) return;
    const apart = (marks) => spread(marks, this.begin, this.end, width, kApart);
    const {names} = this.run.recording;
    const inLane = names.map((name) => this.marks.filter((mark) => mark.sort === 'recovery' && mark.localizer === name));
    this.placeMarks(apart(this.marks.filter((mark) => !inLane.flat().includes(mark))), inLane.map(apart), width);
    this.draw();
  }

  /**
   * The button of a mark stays as long as the mark does: it may have the focus, or be pressed just now. `inLanes`: the
   * recoveries of each localizer, which stand above its bar.
   */
  placeMarks(marks, inLanes, width) {
    const before = this.buttons;
    const all = [...marks, ...inLanes.flat()];
    this.buttons = new Map(all.map((mark) => [mark.label, before.get(mark.label) ?? this.buttonOf(mark)]));
    for (const [label, button] of before) if (!this.buttons.has(label)) button.remove();
    this.fill(this.markRow, marks, width);
    this.fill(this.laneMarks, inLanes.flat(), width);
    inLanes.forEach((lane, k) => lane.forEach(({label}) => {
      this.buttons.get(label).style.top = `${k * kRow}px`;
    }));
  }

  fill(row, marks, width) {
    marks.forEach(({time, label}, i) => {
      const button = this.buttons.get(label);
      if (row.children[i] !== button) row.insertBefore(button, row.children[i] ?? null);
      button.style.left = `${this.x(time, width)}px`;
    });
  }

  buttonOf({sort, symbol, label, time}) {
    return element('button', {type: 'button', class: `mark ${sort}`, 'aria-label': `Jump to ${label}`, title: label,
      click: () => this.seek(time)}, symbol);
  }

  draw() {
    const {clientWidth: width, clientHeight: height} = this.lanes;
    if (!width) return;
    const ratio = devicePixelRatio || 1;
    this.lanes.width = Math.round(width * ratio);
    this.lanes.height = Math.round(height * ratio);
    const context = this.lanes.getContext('2d');
    context.scale(ratio, ratio);
    this.run.states.forEach((states, k) => this.drawLane(context, states, k, width));
  }

  drawLane(context, states, k, width) {
    const colors = this.colors();
    const middle = (k + 1) * kRow - kLane / 2 - 1;
    context.font = '12px system-ui, sans-serif';
    context.fillStyle = colors.soft;
    context.fillText(this.run.recording.names[k], kThumb, middle - kLane / 2 - 3);
    for (const {state, from, to} of stretches(states, this.run.recording.time, this.end)) {
      const left = this.x(from, width);
      const wide = Math.max(1, this.x(to, width) - left);
      if (state === kUnknown) continue;
      context.fillStyle = state === kWrong ? colors.bad : pick(colors.localizers, styleOf(this.run.recording.names, k));
      if (state === kRight) context.fillRect(left, middle - 2, wide, 4);
      if (state === kWrong) context.fillRect(left, middle - kLane / 2, wide, kLane);
      if (state === kSaysLost || state === kFalseAlarm) this.hatch(context, left, middle, wide);
    }
  }

  hatch(context, left, middle, wide) {
    context.save();
    context.beginPath();
    context.rect(left, middle - kLane / 2, wide, kLane);
    context.clip();
    context.strokeStyle = context.fillStyle;
    context.lineWidth = 1.5;
    for (let x = left - kLane; x < left + wide + kLane; x += 5) {
      context.beginPath();
      context.moveTo(x, middle + kLane / 2);
      context.lineTo(x + kLane, middle - kLane / 2);
      context.stroke();
    }
    context.restore();
  }

  show(time, scan) {
    this.slider.value = time;
    const words = this.run.states.map((states, k) =>
      `${this.run.recording.names[k]} ${kStateWords[states[scan]] ?? ''}`);
    this.slider.setAttribute('aria-valuetext', `${clockText(time)}: ${words.join(', ')}`);
  }
}
