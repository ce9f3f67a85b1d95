// A page of any other result: its figures, and its lists as tables.

import { NONE, count, h, number, plural } from './dom.js';
import { facts, figure, figures, messages, record, section } from './layout.js';
import { table } from './table.js';

/** More objects than these in one cell are only counted. */
const FEW = 3;
const words = (key) => key.replaceAll('_', ' ').replace(/ (mm|deg|min|kg)$/, ' ($1)');
const isObject = (value) => value !== null && typeof value === 'object' && !Array.isArray(value);

/** Decimals of a column by its unit, so that its numbers stand under each other; others have as many as they need. */
const DECIMALS = { mm: 4, deg: 4, min: 2 };
const decimalsOf = (key) => DECIMALS[/[ _(](mm|deg|min)\)?$/.exec(key)?.[1]];

function shown(value, decimals) {
  if (value === null || value === undefined) return NONE;
  if (typeof value === 'number') return decimals === undefined ? number(value) : value.toFixed(decimals);
  if (typeof value === 'boolean') return value ? 'yes' : 'no';
  if (Array.isArray(value)) return value.length > FEW && value.every(isObject) ? plural(value.length, 'value') : value.map((one) => shown(one, decimals)).join(', ');
  if (isObject(value)) return Object.entries(value).map(([key, one]) => `${words(key)} ${shown(one)}`).join('; ');
  return String(value);
}

/** A list of objects as a table with the keys that they have. */
export function listOf(name, rows) {
  const flat = rows.map((row) => (isObject(row) ? flatten(row) : { value: row }));
  const isCompound = (key) => flat.some((row) => Array.isArray(row[key]) || isObject(row[key]));
  const all = [...new Set(flat.flatMap((row) => Object.keys(row)))].filter((key) => flat.some((row) => row[key] !== null));
  // what takes most room comes last
  const keys = [...all.filter((key) => !isCompound(key)), ...all.filter(isCompound)];
  const columns = keys.map((key) => ({
    key, label: words(key), number: flat.every((row) => row[key] === null || row[key] === undefined || typeof row[key] === 'number'),
    value: (row) => (isObject(row[key]) || Array.isArray(row[key]) ? shown(row[key]) : row[key]), text: (row) => shown(row[key], decimalsOf(key)),
  }));
  return table({ caption: words(name), name, columns, rows: flat }).element;
}

/** One level of objects within an object beside its own keys. */
function flatten(row) {
  return Object.fromEntries(Object.entries(row).flatMap(([key, value]) => (isObject(value) ? Object.entries(value).map(([inner, one]) => [`${key}_${inner}`, one]) : [[key, value]])));
}

export function plain({ command, data, view, version }) {
  const entries = Object.entries(data);
  const single = entries.filter(([, value]) => !isObject(value) && !Array.isArray(value));
  const lists = entries.filter(([, value]) => Array.isArray(value) && value.length > 0);
  const objects = entries.filter(([, value]) => isObject(value));
  const sections = [
    section('overview', 'Overview', 'Overview',
      view.messages?.length > 0 && messages(view.messages, 'warn'),
      figures(single.map(([key, value]) => figure(words(key), shown(value)))),
      objects.map(([key, value]) => [h('h3', { text: words(key) }), facts(Object.entries(value).map(([name, one]) => [words(name), shown(one)]))])),
    ...lists.map(([key, rows]) => section(`list-${key}`, `${words(key)}: ${count(rows.length)}`, words(key), listOf(key, rows))),
    record(view.provenance ?? [], version),
  ].map((one) => () => one);
  return { kind: command, verdict: null, tone: '', sections };
}
