// What pages of results have in common.

import { count } from './dom.js';
import { section } from './layout.js';
import { listOf } from './plain.js';

/** Lists of the JSON as tables, those that hold anything. */
export const lists = (data, names) => Object.entries(names).filter(([key]) => data[key]?.length > 0)
  .map(([key, title]) => section(`list-${key}`, `${title}: ${count(data[key].length)}`, title, listOf(key, data[key])));

/** The keys that matter in their order; the others are left to the JSON. */
export const ordered = (row, keys) => Object.fromEntries(keys.filter((key) => key in row).map((key) => [key, row[key]]));
