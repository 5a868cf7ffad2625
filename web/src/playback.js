// Time in the player: plays, stops, steps, jumps.

export const kSpeeds = [0.1, 0.25, 0.5, 1, 2, 4, 8, 16];

/** A clock over the scans' times. Calls `changed` after every change. */
export class Playback {
  constructor(times, changed) {
    this.times = times;
    this.begin = times[0] ?? 0;
    this.end = times.at(-1) ?? 0;
    this.time = this.begin;
    this.speed = 1;
    this.playing = false;
    this.changed = changed;
  }

  seek(time) {
    this.time = Math.min(this.end, Math.max(this.begin, time));
    this.changed();
  }

  /** Plays from the beginning again where it had ended. */
  toggle() {
    this.playing = !this.playing;
    if (this.playing && this.time >= this.end) this.time = this.begin;
    this.changed();
  }

  pause() {
    this.playing = false;
    this.changed();
  }

  /** To the scan `count` before (below 0) or after this one, standing still. */
  step(count) {
    this.playing = false;
    const at = lastAtMost(this.times, this.time + 1e-9);
    const to = Math.min(this.times.length - 1, Math.max(0, at + count));
    this.seek(this.times[to] ?? this.begin);
  }

  /** One of `kSpeeds` further. */
  faster(count) {
    const at = kSpeeds.indexOf(this.speed);
    this.setSpeed(kSpeeds[Math.min(kSpeeds.length - 1, Math.max(0, at + count))]);
  }

  setSpeed(speed) {
    this.speed = speed;
    this.changed();
  }

  /** To the next of these times (`direction` 1) or the one before (-1); stays where there is none. */
  jump(stamps, direction) {
    const there = direction > 0
      ? stamps.find((t) => t > this.time + 1e-6)
      : stamps.filter((t) => t < this.time - 1e-6).at(-1);
    if (there !== undefined) this.seek(there);
  }

  /** `elapsed` seconds of wall-clock time went by. True while it plays. */
  advance(elapsed) {
    if (!this.playing) return false;
    this.time = Math.min(this.end, this.time + elapsed * this.speed);
    if (this.time >= this.end) this.playing = false;
    this.changed();
    return this.playing;
  }
}

function lastAtMost(times, time) {
  let i = times.length - 1;
  while (i > 0 && times[i] > time) --i;
  return i;
}
