// What pages of results have in common.

import { count, h } from './dom.js';
import { later, section } from './layout.js';
import { listOf } from './plain.js';

export const printed = (view) => view.text && later('The report as printed', () => h('pre', { class: 'report', tabIndex: 0, text: view.text }));

/** Lists of the JSON as tables, those that hold anything. */
export const lists = (data, names) => Object.entries(names).filter(([key]) => data[key]?.length > 0)
  .map(([key, title]) => section(`list-${key}`, `${title}: ${count(data[key].length)}`, title, listOf(key, data[key])));

/** The keys that matter in their order; the others are left to the JSON. */
export const ordered = (row, keys) => Object.fromEntries(keys.filter((key) => key in row).map((key) => [key, row[key]]));
