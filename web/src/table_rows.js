// Rows of a table as plain data: order, filter, CSV. A cell is {text, value}; value: a number or null.

/** Numbers come before texts, in either direction; equal ones stay in their order. */
export function compareCells(a, b, direction) {
  if (a.value !== null && b.value !== null) return direction * (a.value - b.value);
  if (a.value !== null) return -1;
  if (b.value !== null) return 1;
  return direction * (a.text < b.text ? -1 : a.text > b.text ? 1 : 0);
}

/** True if every word of the filter is in the row. */
export function matches(texts, filter) {
  const row = texts.join(' ').toLowerCase();
  return filter.toLowerCase().split(/\s+/).every((word) => row.includes(word));
}

function csvCell(text) {
  return /[",\n\r]/.test(text) ? `"${text.replaceAll('"', '""')}"` : text;
}

/** Head and rows as CSV (RFC 4180, with line feeds). A dash is an empty cell. */
export function csvText(head, rows) {
  const cell = ({text, value}) => (value !== null ? String(value) : text === '–' ? '' : text);
  const lines = [head, ...rows.map((row) => row.map(cell))];
  return lines.map((line) => `${line.map(csvCell).join(',')}\n`).join('');
}
