// How much of a long list stands on paper, and what says so there.

import { count, plural } from './dom.js';

/** So many rows of a table, or lines of source. */
export const PRINTED = 400;

/** What stands above them, so that nobody signs a part for the whole; `shown` of `all` are left by search and filters. */
export function printedRows(shown, all, word) {
  const some = Math.min(shown, PRINTED);
  if (some === all) return plural(all, word);
  const why = [shown < all && 'that match the search', shown > PRINTED && `the first ${count(PRINTED)} in this order`].filter(Boolean);
  return `Printed: ${count(some)} of ${plural(all, word)}, ${why.join(', ')}.`;
}
