// Words of marks over a plot: each above its line, in as many rows as keep them apart.

import { h } from './dom.js';

const ROW = 16;
const GAP = 6;
/** Marks beyond so many rows have their line alone; who shows them lists them as well. */
const MOST_ROWS = 6;

/** A strip that stands above a plot; `place(at)` is where a mark stands in it, in pixels from the left, of `width`. */
export class MarkLabels {
  constructor() {
    this.element = h('div', { class: 'mark-labels', 'aria-hidden': 'true' });
  }

  show(marks, place, [left, right], width) {
    const seen = marks.filter((mark) => mark.label && place(mark.at) >= left - 1 && place(mark.at) <= right + 1);
    const flags = seen.map((mark) => {
      const element = h('span', { class: 'mark-label', text: mark.label });
      return { element, x: place(mark.at) };
    });
    this.element.replaceChildren(...flags.map((flag) => flag.element));
    flags.forEach((flag) => { flag.wide = Math.min(flag.element.getBoundingClientRect().width, width); });
    const ends = [];
    for (const flag of flags) {
      // beside its line, on its left where the window ends
      flag.from = Math.max(Math.min(flag.x, width - flag.wide), 0);
      const free = ends.findIndex((end) => end + GAP <= flag.from);
      flag.row = free < 0 ? ends.length : free;
      ends[flag.row] = flag.from + flag.wide;
    }
    const rows = Math.min(ends.length, MOST_ROWS);
    this.element.style.height = `${rows * ROW}px`;
    for (const { element, row, from, x } of flags) {
      element.hidden = row >= MOST_ROWS;
      element.style.left = `${from.toFixed(1)}px`;
      // the first row is next to the plot
      element.style.top = `${(rows - 1 - row) * ROW}px`;
      const pole = h('span', { class: 'mark-pole' });
      pole.style.left = `${x.toFixed(1)}px`;
      pole.style.top = `${(rows - row) * ROW - 2}px`;
      if (!element.hidden) this.element.prepend(pole);
    }
  }
}
