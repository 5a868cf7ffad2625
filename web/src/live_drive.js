// Driving by keys or by a gamepad: a velocity while something is pressed.

const kFast = 0.26;  // [m/s] A Waffle's.
const kTurn = 1.2;  // [rad/s]
const kKeys = {w: [1, 0], s: [-1, 0], a: [0, 1], d: [0, -1]};
const kIdle = 0.15;  // Share of a gamepad's stick that is no command.
const kPeriod = 100;  // [ms] Between two looks at the gamepads.

const share = (value) => (Math.abs(value) < kIdle ? 0 : -value);

/** The command of pressed keys and of a gamepad's left stick; null: none. */
export function commandOf(pressed, gamepad) {
  let [v, w] = [0, 0];
  for (const key of pressed) {
    v += kKeys[key][0];
    w += kKeys[key][1];
  }
  if (gamepad) {
    v += share(gamepad.axes[1] ?? 0);
    w += share(gamepad.axes[0] ?? 0);
  }
  if (v === 0 && w === 0) return null;
  const limit = (value) => Math.max(-1, Math.min(1, value));
  return {v: Number((kFast * limit(v)).toFixed(3)), w: Number((kTurn * limit(w)).toFixed(3))};
}

/** Sends `drive` events when the command changes. */
export class LiveDrive {
  constructor(send) {
    this.send = send;
    this.pressed = new Set();
    this.last = 'null';
    this.timer = setInterval(() => this.look(), kPeriod);
  }

  /** True if the key is one to drive by. */
  key({key, type, repeat}) {
    const name = key.toLowerCase();
    if (!(name in kKeys)) return false;
    if (type === 'keydown') this.pressed.add(name);
    else this.pressed.delete(name);
    if (!repeat) this.look();
    return true;
  }

  /** No key is pressed any more: the page lost the keyboard. */
  release() {
    this.pressed.clear();
    this.look();
  }

  end() {
    clearInterval(this.timer);
  }

  look() {
    const gamepad = [...(navigator.getGamepads?.() ?? [])].find(Boolean);
    const command = commandOf(this.pressed, gamepad);
    const text = JSON.stringify(command);
    if (text === this.last) return;
    this.last = text;
    this.send({drive: command ?? {}});
  }
}
