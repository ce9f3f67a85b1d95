// Bars as plain SVG: a value of each row on one scale, with its interval where there is one.

import { h, svg } from './dom.js';

const ROW = 36;
const WIDE = 99;

/** Rows are `{ label, value, text, colour, interval: [low, high] }`, values from 0 to `most`. */
export function bars({ label, rows, most }) {
  const x = (value) => Math.min(Math.max(value / most, 0), 1) * WIDE;
  const parts = rows.flatMap((row, i) => {
    const y = i * ROW;
    const interval = row.interval
      ? [svg('line', { x1: `${x(row.interval[0])}%`, x2: `${x(row.interval[1])}%`, y1: y + 24, y2: y + 24, class: 'bar-interval' })]
      : [];
    return [
      svg('text', { x: 0, y: y + 13, class: 'bar-name' }, row.label, svg('tspan', { dx: 8, class: 'bar-value' }, row.text)),
      svg('rect', { x: 0, y: y + 18, width: `${Math.max(x(row.value), 0.3)}%`, height: 12, class: `bar-${row.colour ?? 'plain'}`, rx: 1.5 }),
      ...interval,
    ];
  });
  const text = rows.map((row) => `${row.label} ${row.text}`).join('; ');
  return h('div', { class: 'bars' }, svg('svg', { width: '100%', height: rows.length * ROW, role: 'img', 'aria-label': `${label}: ${text}` }, parts));
}
