import assert from 'node:assert/strict';
import {test} from 'node:test';
import {curvesCsv} from '../src/curve_rows.js';

test('a row a scan, with nothing where there is no value', () => {
  const localizer = {known: [1, 0], quality: [0.5, 0], probability: [-1, 0], sigma: [0.1, 0], populations: [2, 0]};
  const run = {
    recording: {names: ['amcl'], time: [0.1, 0.2], localizers: [localizer]},
    errors: [{position: [1 / 3, null], yaw: [0.25, null]}],
  };
  assert.equal(curvesCsv(run), [
    'time_s,amcl.error_m,amcl.yaw_error_rad,amcl.quality,amcl.probability,amcl.sigma_m,amcl.hypotheses',
    '0.1,0.3333333,0.25,0.5,,0.1,2',
    '0.2,,,,,,0',
    '',
  ].join('\n'));
});
