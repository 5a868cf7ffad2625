import assert from 'node:assert/strict';
import {test} from 'node:test';
import {compareCells, csvText, matches} from '../src/table_rows.js';

const number = (value) => ({text: `${value} s`, value});
const word = (text) => ({text, value: null});

function sorted(cells, direction) {
  return [...cells].sort((a, b) => compareCells(a, b, direction)).map(({text}) => text);
}

test('numbers are sorted as numbers', () => {
  assert.deepEqual(sorted([number(10), number(9), number(-1)], 1), ['-1 s', '9 s', '10 s']);
  assert.deepEqual(sorted([number(10), number(9), number(-1)], -1), ['10 s', '9 s', '-1 s']);
});

test('texts stand behind numbers, in either direction', () => {
  assert.deepEqual(sorted([word('–'), number(2), word('a')], 1), ['2 s', 'a', '–']);
  assert.deepEqual(sorted([word('–'), number(2), word('a')], -1), ['2 s', '–', 'a']);
});

test('a filter asks for all of its words', () => {
  assert.ok(matches(['mh_amcl', 'lidar.range_max = 3'], 'AMCL 3'));
  assert.ok(!matches(['mh_amcl', 'lidar.range_max = 3'], 'amcl 4'));
  assert.ok(matches(['x'], ''));
});

test('CSV has numbers as they are, quotes, and nothing for a dash', () => {
  const rows = [[word('a, "b"'), number(0.125), word('–')]];
  assert.equal(csvText(['name', 'time', 'error'], rows), 'name,time,error\n"a, ""b""",0.125,\n');
});
