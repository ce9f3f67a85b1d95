// A page of a result without pictures: what the report says, its figures, and all of its lists as tables.

import { NONE, count, h, number, plural } from './dom.js';
import { facts, figure, figures, later, messages, notes, printed, record, section } from './layout.js';
import { REPORTS } from './reports.js';
import { table } from './table.js';

/** More objects than these in one cell are rows of a table of their own. */
const FEW = 3;
const words = (key) => key.replaceAll('_', ' ').replace(/ (mm|deg|min|kg)$/, ' ($1)');
const isObject = (value) => value !== null && typeof value === 'object' && !Array.isArray(value);
const isLong = (value) => Array.isArray(value) && value.length > FEW && value.every(isObject);

/** Decimals of a column by its unit, so that its numbers stand under each other; others have as many as they need. */
const DECIMALS = { mm: 4, deg: 4, min: 2, share: 3, '±': 3, sigmas: 1 };
const decimalsOf = (key) => DECIMALS[/[ _(](mm|deg|min|share|±|sigmas)\)?$/.exec(key)?.[1]];

function shown(value, decimals) {
  if (value === null || value === undefined) return NONE;
  if (typeof value === 'number') return decimals === undefined ? number(value) : value.toFixed(decimals);
  if (typeof value === 'boolean') return value ? 'yes' : 'no';
  if (isLong(value)) return `${plural(value.length, 'row')} below`;
  if (Array.isArray(value)) return value.map((one) => shown(one, decimals)).join(', ');
  if (isObject(value)) return Object.entries(value).map(([key, one]) => `${words(key)} ${shown(one)}`).join('; ');
  return String(value);
}

/** A list of objects as a table with the keys that they have. */
export function listOf(name, rows) {
  const flat = rows.map((row) => (isObject(row) ? flatten(row) : { value: row }));
  const isCompound = (key) => flat.some((row) => Array.isArray(row[key]) || isObject(row[key]));
  const isLongText = (key) => flat.some((row) => typeof row[key] === 'string' && row[key].length > 40);
  const all = [...new Set(flat.flatMap((row) => Object.keys(row)))].filter((key) => flat.some((row) => row[key] !== null && row[key] !== undefined));
  // what takes most room comes last
  const keys = [...all.filter((key) => !isCompound(key)), ...all.filter(isCompound)];
  const columns = keys.map((key) => ({
    key, label: words(key), number: flat.every((row) => row[key] === null || row[key] === undefined || typeof row[key] === 'number'), class: isLongText(key) ? 'reason' : undefined,
    value: (row) => (isObject(row[key]) || Array.isArray(row[key]) ? shown(row[key]) : row[key]), text: (row) => shown(row[key], decimalsOf(key)),
  }));
  return table({ caption: words(name), name, columns, rows: flat }).element;
}

/** One level of objects within an object beside its own keys. */
function flatten(row) {
  return Object.fromEntries(Object.entries(row).flatMap(([key, value]) => (isObject(value) ? Object.entries(value).map(([inner, one]) => [`${key}_${inner}`, one]) : [[key, value]])));
}

/** Lists within the rows of a list that are too long for a cell: a folded table of each, with what names the row. */
function inner(name, rows) {
  const flat = rows.filter(isObject).map(flatten);
  const keys = [...new Set(flat.flatMap((row) => Object.keys(row).filter((key) => isLong(row[key]))))];
  return keys.map((key) => {
    const all = flat.flatMap((row) => {
      const single = Object.entries(row).filter(([, value]) => value !== null && typeof value !== 'object').slice(0, 3);
      return Array.isArray(row[key]) ? row[key].map((one) => ({ ...Object.fromEntries(single.map(([of, value]) => [`of_${of}`, value])), ...one })) : [];
    });
    return later(`${words(name)}, ${words(key)}: ${plural(all.length, 'row')}`, () => listOf(`${name}-${key}`, all), { printed: true });
  });
}

const listSection = (key, title, short, rows, ...more) => section(`list-${key}`, `${title}: ${count(rows.length)}`, short, listOf(key, rows), inner(key, rows), more);

/** A list that a report describes: its title, its rows as people read them, and what is folded beneath. */
function described({ key, title, short, rows, notice, folded }) {
  if (rows.length === 0) return null;
  return listSection(key, title, short ?? title, rows, notice && h('p', { class: 'notice', text: notice }),
    (folded ?? []).filter((one) => one.rows.length > 0).map((one) => later(`${one.title}: ${plural(one.rows.length, 'row')}`, () => listOf(one.key, one.rows))));
}

export function plain({ command, data, view, version }) {
  const report = REPORTS[command]?.(data);
  const known = new Set(['notes', 'warnings', ...(report?.shown ?? [])]);
  const entries = Object.entries(data).filter(([key]) => !known.has(key));
  const single = entries.filter(([, value]) => !isObject(value) && !Array.isArray(value));
  const lists = entries.filter(([, value]) => Array.isArray(value) && value.length > 0);
  const objects = entries.filter(([, value]) => isObject(value));
  const withinObjects = objects.flatMap(([key, value]) => Object.entries(value).filter(([, one]) => isLong(one)).map(([name, rows]) => [`${key}_${name}`, rows]));
  const sections = [
    section('overview', 'Overview', 'Overview',
      [...(data.warnings ?? []), ...(view.messages ?? [])].length > 0 && messages([...(data.warnings ?? []), ...(view.messages ?? [])], 'warn'),
      notes(data.notes),
      (report?.figures || single.length > 0) && figures((report?.figures ?? []).map((one) => figure(...one)), single.map(([key, value]) => figure(words(key), shown(value)))),
      objects.map(([key, value]) => [h('h3', { class: 'apart', text: words(key) }), facts(Object.entries(value).map(([name, one]) => [words(name), shown(one)]))]),
      printed(view)),
    ...(report?.lists ?? []).map(described),
    ...[...lists, ...withinObjects].map(([key, rows]) => listSection(key, words(key), words(key), rows)),
    record(view.provenance ?? [], version),
  ].map((one) => () => one);
  const [verdict, tone] = report?.verdict ?? [null, ''];
  return { kind: report?.kind ?? command, verdict, tone, sections };
}
