// Whole numbers as bytes, as tools/base/bytes/varint.hpp writes them.

/** Reads numbers from `bytes`, from `at` on. Numbers beyond 2^53 do not occur in recordings. */
export class Reader {
  constructor(bytes, at = 0) {
    this.bytes = bytes;
    this.at = at;
  }

  get done() {
    return this.at >= this.bytes.length;
  }

  /** A number of 0 or more. */
  next() {
    let value = 0;
    for (let factor = 1; ; factor *= 128) {
      if (this.done) throw new RangeError('the recording ends within a number');
      const byte = this.bytes[this.at++];
      value += (byte & 127) * factor;
      if (byte < 128) return value;
    }
  }

  /** A number of either sign: zigzag. */
  nextSigned() {
    const value = this.next();
    return value % 2 === 1 ? -(value + 1) / 2 : value / 2;
  }
}

/** The numbers of a column, which are kept as differences, times `step`. */
export function column(bytes, count, step = 1) {
  const values = new Float64Array(count);
  const reader = new Reader(bytes);
  let last = 0;
  for (let i = 0; i < count; ++i) {
    last += reader.nextSigned();
    values[i] = last * step;
  }
  if (!reader.done) throw new RangeError('a column has more numbers than the recording scans');
  return values;
}
