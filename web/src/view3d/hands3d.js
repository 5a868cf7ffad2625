// What pointer, wheel and keys do to the camera of the 3-D view.

const kTurn = 0.008;  // [rad/px]
const kKeyTurn = 0.09;  // [rad]
const kKeyMove = 40;  // [px]

/** `act`: {orbit(right, up) [rad], drag(dx, dy) [px], zoom(factor)}. */
export class Hands3d {
  constructor(canvas, act) {
    this.act = act;
    this.canvas = canvas;
    this.fingers = new Map();
    canvas.addEventListener('pointerdown', (event) => this.down(event));
    canvas.addEventListener('pointermove', (event) => this.move(event));
    for (const name of ['pointerup', 'pointercancel']) canvas.addEventListener(name, (event) => this.fingers.delete(event.pointerId));
    canvas.addEventListener('contextmenu', (event) => event.preventDefault());
    canvas.addEventListener('keydown', (event) => this.key(event));
    canvas.addEventListener('wheel', (event) => {
      event.preventDefault();
      act.zoom(1.0015 ** -event.deltaY);
    }, {passive: false});
  }

  down(event) {
    this.canvas.setPointerCapture(event.pointerId);
    this.fingers.set(event.pointerId, [event.clientX, event.clientY]);
    this.moves = event.button === 2 || event.button === 1 || event.shiftKey;
  }

  /** One finger turns, two move and zoom. */
  move(event) {
    const before = this.fingers.get(event.pointerId);
    if (!before) return;
    const now = [event.clientX, event.clientY];
    const other = [...this.fingers].find(([id]) => id !== event.pointerId)?.[1];
    this.fingers.set(event.pointerId, now);
    const [dx, dy] = [now[0] - before[0], now[1] - before[1]];
    if (other) {
      const length = (p) => Math.max(10, Math.hypot(p[0] - other[0], p[1] - other[1]));
      this.act.drag(0.5 * dx, 0.5 * dy);
      this.act.zoom(length(now) / length(before));
    } else if (this.moves) {
      this.act.drag(dx, dy);
    } else {
      this.act.orbit(kTurn * dx, kTurn * dy);
    }
  }

  /** Arrows turn the view, with shift they move it. */
  key(event) {
    const ways = {ArrowLeft: [1, 0], ArrowRight: [-1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1]};
    const way = ways[event.key];
    if (!way || event.ctrlKey || event.metaKey || event.altKey) return;
    event.preventDefault();
    event.stopPropagation();
    if (event.shiftKey) this.act.drag(kKeyMove * way[0], kKeyMove * way[1]);
    else this.act.orbit(-kKeyTurn * way[0], kKeyTurn * way[1]);
  }
}
