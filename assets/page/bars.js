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

/** Thin bars over whole numbers: lines of a spectrum. */
export function stems({ label, rows, note }) {
  const most = Math.max(...rows.map((row) => row.value), 1e-12);
  const last = Math.max(...rows.map((row) => row.n), 4);
  const x = (n) => 3 + (n / (last * 1.05)) * 94;
  const parts = rows.flatMap((row) => {
    const top = 96 - (row.value / most) * 78;
    return [
      svg('line', { x1: `${x(row.n)}%`, x2: `${x(row.n)}%`, y1: 96, y2: top, class: 'stem' }),
      svg('text', { x: `${x(row.n)}%`, y: top - 4, 'text-anchor': 'middle', class: 'bar-value' }, String(row.n)),
    ];
  });
  return h('figure', { class: 'stems' }, h('figcaption', { text: label }),
    svg('svg', { width: '100%', height: 100, role: 'img', 'aria-label': `${label}: ${rows.map((row) => `${row.n} per turn ${row.text}`).join(', ')}` },
      svg('line', { x1: '1%', x2: '99%', y1: 96, y2: 96, class: 'axis' }), parts),
    h('p', { class: 'note', text: note }));
}
