// The curves of a run as a table: a row a scan.
import {csvText} from './table_rows.js';

const kColumns = [
  ['error_m', (k, i, {errors}) => errors[k].position[i]],
  ['yaw_error_rad', (k, i, {errors}) => errors[k].yaw[i]],
  ['quality', (k, i, run) => answered(run, k, i, 'quality')],
  ['probability', (k, i, run) => answered(run, k, i, 'probability')],
  ['sigma_m', (k, i, run) => answered(run, k, i, 'sigma')],
  ['hypotheses', (k, i, {recording}) => recording.localizers[k].populations[i]],
];

/** Nothing where the localizer has no answer, or does not state the value. */
function answered({recording}, k, i, name) {
  const localizer = recording.localizers[k];
  return localizer.known[i] && localizer[name][i] >= 0 ? localizer[name][i] : null;
}

/** CSV of `run`: {recording, errors}. Empty cells: no value. */
export function curvesCsv(run) {
  const {recording} = run;
  const cell = (value) => (value === null ? {text: '', value: null} : {text: '', value: Number(value.toPrecision(7))});
  const head = ['time_s', ...recording.names.flatMap((name) => kColumns.map(([column]) => `${name}.${column}`))];
  const rows = Array.from(recording.time, (time, i) =>
    [cell(time), ...recording.names.flatMap((_, k) => kColumns.map(([, value]) => cell(value(k, i, run))))]);
  return csvText(head, rows);
}
