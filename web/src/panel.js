// What the localizers say at the time that is shown.
import {element, readable} from './dom.js';
import {hasTruth, kStateWords, kUnknown, kWrong, kRight} from './measures.js';
import {kDashes, outline, pick, styleOf} from './palette.js';

const kScoredRows = ['error', 'yaw error'];
const kStatedRows = ['stated probability', 'quality', 'uncertainty', 'hypotheses'];

/** A dash where there is no answer, or where it does not state the share, which is negative then. */
const shareText = (known, share) => (known && share >= 0 ? share.toFixed(2) : '–');

/** A localizer's line and shape. */
function swatch() {
  return element('canvas', {class: 'swatch', width: 80, height: 40, 'aria-hidden': 'true'});
}

function paint(canvas, style, colors) {
  const context = canvas.getContext('2d');
  context.setTransform(1, 0, 0, 1, 0, 0);
  context.clearRect(0, 0, canvas.width, canvas.height);
  context.scale(2, 2);
  context.strokeStyle = pick(colors.localizers, style);
  context.lineWidth = 2.5;
  context.setLineDash(pick(kDashes, style));
  context.beginPath();
  context.moveTo(20, 10);
  context.lineTo(40, 10);
  context.stroke();
  context.setLineDash([]);
  context.translate(9, 10);
  outline(context, style, 6);
  context.stroke();
}

/** A card a localizer. */
export class Panel {
  constructor(place, run) {
    this.run = run;
    this.truth = hasTruth(run.recording);
    const rows = [...(this.truth ? kScoredRows : []), ...kStatedRows];
    this.cards = run.recording.names.map((name) => {
      const values = rows.map(() => element('dd', {}));
      const state = element('span', {class: 'state'});
      const picture = swatch();
      place.append(element('div', {class: 'card'},
        element('h2', {}, picture, element('span', {class: 'name'}, name), state),
        element('dl', {}, ...rows.flatMap((row, i) => [element('dt', {}, row), values[i]]))));
      return {values, state, picture};
    });
  }

  recolor(colors) {
    this.cards.forEach((card, k) => paint(card.picture, styleOf(this.run.recording.names, k), colors));
  }

  /** A word for a state; why, where it is not scored. */
  word(k, scan, state) {
    const {recording} = this.run;
    if (state !== kUnknown) return kStateWords[state];
    if (recording.torn[scan]) return 'scan torn by a kidnap';
    return recording.localizers[k].known[scan] ? kStateWords[kUnknown] : 'no answer';
  }

  show(scan) {
    const {recording, errors, states} = this.run;
    this.cards.forEach((card, k) => {
      const localizer = recording.localizers[k];
      const known = localizer.known[scan];
      const yaw = errors[k].yaw[scan] ?? null;
      const scored = [
        readable(errors[k].position[scan] ?? null, 'm'),
        readable(yaw === null ? null : (yaw * 180) / Math.PI, '°'),
      ];
      const texts = [
        ...(this.truth ? scored : []),
        shareText(known, localizer.probability[scan]),
        shareText(known, localizer.quality[scan]),
        known ? `± ${readable(localizer.sigma[scan], 'm')}` : '–',
        `${localizer.populations[scan]} (${localizer.particles[scan]} particles)`,
      ];
      texts.forEach((text, i) => {
        if (card.values[i].textContent !== text) card.values[i].textContent = text;
      });
      const state = states[k][scan] ?? kUnknown;
      card.state.textContent = this.word(k, scan, state);
      card.state.className = `state ${state === kRight ? 'good' : state === kWrong ? 'bad' : 'warn'}`;
    });
  }
}
