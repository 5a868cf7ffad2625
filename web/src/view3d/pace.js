// How finely the 3-D view is drawn: coarser where pictures come too slowly.

const kSlow = 38;  // [ms] Between pictures: less than 26 a second.
const kPatience = 12;  // Pictures that are looked at before anything changes.
const kPause = 250;  // [ms] A longer time between pictures means that nothing moved.
const kCoarser = 0.85;
const kCoarsest = 0.6;
const kFirstWait = 6;  // Times of patience before finer pictures are tried; twice as many after each that fails.

export class Pace {
  constructor() {
    this.scale = 1;
    this.wait = kFirstWait;
    this.good = 0;
    this.reset();
  }

  reset() {
    this.last = null;
    this.sum = 0;
    this.count = 0;
  }

  /** All pixels again: the picture stands still. */
  rest() {
    this.scale = 1;
    this.reset();
  }

  /** A picture is drawn at `now` [ms]; the share of the pixels in each direction that it may have. */
  add(now) {
    const way = this.last === null ? Infinity : now - this.last;
    if (way > kPause) this.reset();
    else this.sum += way;
    this.last = now;
    if (way > kPause || ++this.count < kPatience) return this.scale;
    this.judge(this.sum / this.count);
    this.sum = 0;
    this.count = 0;
    return this.scale;
  }

  judge(way) {
    if (way > kSlow) {
      if (this.tried) this.wait *= 2;
      this.scale = Math.max(kCoarsest, kCoarser * this.scale);
      this.good = 0;
    } else {
      ++this.good;
    }
    this.tried = this.good >= this.wait && this.scale < 1;
    if (!this.tried) return;
    this.scale = Math.min(1, this.scale / kCoarser);
    this.good = 0;
  }
}
