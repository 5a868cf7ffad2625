// Tables that are sorted by their heads, filtered, reduced to rows with a failure (class "bad"), and saved as CSV. Long ones show their first rows on screens until
// all are asked for; printed, they show all.
import {element} from './dom.js';
import {save} from './saving.js';
import {compareCells, csvText, matches} from './table_rows.js';

const kFirst = 25;

function cellOf(td) {
  const value = td.dataset.value;
  const text = td.querySelector('code')?.textContent ?? td.textContent;
  return {text, value: value === undefined ? null : Number(value)};
}

/** A table and what was chosen for it. */
class DataTable {
  constructor(table) {
    this.table = table;
    this.heads = [...table.tHead.rows[0].cells];
    this.names = this.heads.map((th) => th.textContent.trim());
    this.rows = [...table.tBodies[0].rows].map((row) => ({row, cells: [...row.cells].map(cellOf)}));
    this.filter = '';
    this.failures = this.rows.filter(({row}) => row.querySelector('.bad')).length;
    this.failuresOnly = false;
    this.whole = this.rows.length <= kFirst;
    this.count = element('span', {class: 'soft'});
    this.more = element('button', {type: 'button', click: () => {
      this.whole = true;
      this.show();
    }}, 'Show all');
    this.addTools();
    this.heads.forEach((th, column) => this.addSorting(th, column));
    this.show();
  }

  matching() {
    return this.rows.filter(({row, cells}) => matches(cells.map(({text}) => text), this.filter)
      && (!this.failuresOnly || row.querySelector('.bad')));
  }

  show() {
    const matching = this.matching();
    for (const {row} of this.rows) row.hidden = true;
    matching.forEach(({row}, i) => {
      row.hidden = false;
      row.classList.toggle('beyond', !this.whole && i >= kFirst);
    });
    this.more.hidden = this.whole || matching.length <= kFirst;
    this.count.textContent = `${matching.length} of ${this.rows.length} rows`;
  }

  addTools() {
    const filter = element('input', {type: 'search', placeholder: 'filter', 'aria-label': 'Filter rows', input: () => {
      this.filter = filter.value;
      this.show();
    }});
    const only = element('input', {type: 'checkbox', change: () => {
      this.failuresOnly = only.checked;
      this.show();
    }});
    const failures = this.failures ? element('label', {}, only, ` failures only (${this.failures})`) : null;
    const download = element('button', {type: 'button', click: () => this.save()}, 'CSV');
    const box = this.table.closest('.wide');
    box.before(element('p', {class: 'table-tools'}, filter, failures, this.orders(), download, this.count));
    box.after(element('p', {class: 'table-tools'}, this.more));
  }

  /** Sorting for narrow screens, where the heads are not shown. */
  orders() {
    const options = this.names.flatMap((name, column) => [[`${name} ↑`, `${column},1`], [`${name} ↓`, `${column},-1`]]);
    const select = element('select', {class: 'order', 'aria-label': 'Sort rows', change: () => {
      if (select.value !== '') this.sort(...select.value.split(',').map(Number));
    }}, element('option', {value: ''}, 'sort by'),
    ...options.map(([text, value]) => element('option', {value}, text)));
    return select;
  }

  addSorting(th, column) {
    const sort = () => this.sort(column, th.getAttribute('aria-sort') === 'ascending' ? -1 : 1);
    th.replaceChildren(element('button', {type: 'button', class: 'sort', click: sort}, this.names[column]));
  }

  /** `direction`: 1 ascending, -1 descending. */
  sort(column, direction) {
    for (const th of this.heads) th.removeAttribute('aria-sort');
    this.heads[column].setAttribute('aria-sort', direction > 0 ? 'ascending' : 'descending');
    this.rows.sort((a, b) => compareCells(a.cells[column], b.cells[column], direction));
    this.table.tBodies[0].append(...this.rows.map(({row}) => row));
    this.show();
  }

  /** All rows that the filter lets through, in their order. */
  save() {
    const text = csvText(this.names, this.matching().map(({cells}) => cells));
    save(`${this.table.dataset.name}.csv`, text, 'text/csv');
  }
}

/** Makes all tables of class "data" work. */
export function addTables() {
  for (const table of document.querySelectorAll('table.data')) new DataTable(table);
}
