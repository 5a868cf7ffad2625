// Map and 3-D view in one place: one of them is shown.
import {icon} from '../icons.js';
import {element} from '../dom.js';
import {View3d} from './view3d.js';

const kHint = 'drag: turn · right button or two fingers: move · wheel: nearer · hands work in 2-D';

export class Views {
  /** `changed()`: asks for `draw`. `hint`: a line of help in the 3-D view. */
  constructor(mapView, recording, events, state, changed, hint = kHint) {
    this.mapView = mapView;
    this.state = state;
    this.changed = changed;
    this.json = null;
    this.in3d = false;
    this.canvas = element('canvas', {class: 'view-3d', tabindex: 0, role: 'img', hidden: true,
      'aria-label': 'The world with robot, people and ghosts of the localizers; arrow keys turn the view'});
    this.view3d = new View3d(this.canvas, recording, events, state, changed);
    this.note = element('p', {class: 'note-3d', role: 'status', hidden: true});
    this.hint = element('p', {class: 'hint-3d', hidden: true, 'aria-hidden': 'true'}, hint);
    this.build();
  }

  build() {
    const button = (text, act, more) => element('button', {type: 'button', click: act, ...more}, text);
    this.flat = button('2-D', () => this.choose(false), {title: 'Map (3)'});
    this.deep = button('3-D', () => this.choose(true), {title: '3-D view (3)'});
    this.roof = button('Roof', () => this.toggleRoof(), {'aria-pressed': 'false', hidden: true});
    this.above = element('button', {type: 'button', 'aria-label': 'From above (t)', title: 'From above (t)', hidden: true,
      click: () => this.top()}, icon('above'));
    this.row = element('div', {class: 'view-choice', role: 'group', 'aria-label': 'View', hidden: true}, this.flat, this.deep, this.roof);
    this.parts = [this.canvas, this.view3d.labels, this.row, this.hint, this.note];
    this.press();
  }

  /** What can be seen in three dimensions; null: nothing, and there is no choice. */
  setScene(json) {
    this.json = json;
    this.row.hidden = !json;
    if (this.in3d) this.enter();
  }

  setColors(colors) {
    this.mapView.setColors(colors);
    this.view3d.setColors(colors);
  }

  choose(in3d) {
    if (in3d === this.in3d || !this.json) return;
    this.in3d = in3d;
    this.canvas.hidden = !in3d;
    if (in3d) this.enter();
    this.mapView.canvas.classList.toggle('behind', this.in3d);
    this.press();
    this.changed();
  }

  /** Hands the scene over, once. */
  enter() {
    if (this.given === this.json) return;
    this.given = this.json;
    const {thinned_m: cell} = this.json;
    if (this.view3d.setScene(this.json)) {
      this.tell(cell > 0 ? `Meshes are simplified to ${(100 * cell).toFixed(0)} cm.` : '');
      return;
    }
    this.in3d = false;
    this.given = null;
    this.canvas.hidden = true;
    this.deep.disabled = true;
    this.tell('This browser has no WebGL 2, which the 3-D view needs; the map goes on.');
  }

  tell(text) {
    this.note.textContent = text;
    this.note.hidden = !text;
  }

  press() {
    this.flat.setAttribute('aria-pressed', String(!this.in3d));
    this.deep.setAttribute('aria-pressed', String(this.in3d));
    this.above.hidden = this.hint.hidden = this.view3d.labels.hidden = !this.in3d;
    this.roof.hidden = !this.in3d || !this.view3d.hasRoof;
  }

  toggleRoof() {
    const on = this.roof.getAttribute('aria-pressed') !== 'true';
    this.roof.setAttribute('aria-pressed', String(on));
    this.view3d.showRoof(on);
  }

  /** The canvas that is seen. */
  get shown() {
    return this.in3d ? this.canvas : this.mapView.canvas;
  }

  zoom(factor) {
    if (this.in3d) this.view3d.zoom(factor);
    else this.mapView.zoom(factor);
  }

  fit() {
    if (this.in3d) this.view3d.fit();
    else this.mapView.fit();
  }

  top() {
    if (this.in3d) this.view3d.fit(true);
  }

  toggle() {
    this.choose(!this.in3d);
  }

  draw() {
    if (this.in3d) this.view3d.draw();
    else this.mapView.draw();
  }
}
