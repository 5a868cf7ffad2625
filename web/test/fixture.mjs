// The recordings that tests/tools/outputs/sinks/recording_fixture_test.cpp writes.
import {readFileSync} from 'node:fs';
import {fileURLToPath} from 'node:url';

/** `name`: small, or levels with the same on two floors. */
export function fixture(name = 'small') {
  const file = fileURLToPath(new URL(`../../tests/data/recording/${name}.bin`, import.meta.url));
  return new Uint8Array(readFileSync(file));
}

/** Numbers that are near enough to these. */
export function near(found, wanted, tolerance = 1e-9) {
  return found.length === wanted.length &&
    wanted.every((value, i) => Math.abs(value - found[i]) <= tolerance);
}
