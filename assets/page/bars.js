// Bars: a value of each row on one scale, with its interval where there is one. Labels are text that wraps, the bars SVG.

import { h, svg } from './dom.js';

const WIDE = 99;

/** Rows are `{ label, value, text, colour, interval: [low, high] }`, values from 0 to `most`. */
export function bars({ label, rows, most }) {
  const x = (value) => Math.min(Math.max(value / most, 0), 1) * WIDE;
  const one = (row) => h('div', { class: 'bar-row' },
    h('span', { class: 'bar-name', text: row.label }), ' ', h('span', { class: 'bar-value', text: row.text }),
    svg('svg', { width: '100%', height: 12, 'aria-hidden': 'true' },
      svg('rect', { x: 0, y: 0, width: `${Math.max(x(row.value), 0.3)}%`, height: 12, class: `bar-${row.colour ?? 'plain'}`, rx: 1.5 }),
      row.interval ? [svg('line', { x1: `${x(row.interval[0])}%`, x2: `${x(row.interval[1])}%`, y1: 6, y2: 6, class: 'bar-interval' })] : []));
  const text = rows.map((row) => `${row.label} ${row.text}`).join('; ');
  return h('div', { class: 'bars', role: 'img', 'aria-label': `${label}: ${text}` }, rows.map(one));
}
