// Bars as plain SVG: a value of each row on one scale, with its interval where there is one.

import { h, svg } from './dom.js';

const ROW = 26;
const LEFT = 34;

/** Rows are `{ label, value, text, colour, interval: [low, high] }`, values from 0 to `most`. */
export function bars({ label, rows, most }) {
  const width = 100 - LEFT - 14;
  const x = (value) => LEFT + (Math.min(Math.max(value / most, 0), 1) * width);
  const parts = rows.flatMap((row, i) => {
    const y = i * ROW;
    const bar = svg('rect', { x: `${LEFT}%`, y: y + 7, width: `${Math.max(x(row.value) - LEFT, 0.15)}%`, height: 12, class: `bar-${row.colour ?? 'plain'}`, rx: 1.5 });
    const name = svg('text', { x: `${LEFT - 1}%`, y: y + 17, 'text-anchor': 'end', class: 'bar-name' }, row.label);
    const end = row.interval ? Math.max(x(row.interval[1]), x(row.value)) : x(row.value);
    const value = svg('text', { x: `${end + 1}%`, y: y + 17, class: 'bar-value' }, row.text);
    const interval = row.interval
      ? [svg('line', { x1: `${x(row.interval[0])}%`, x2: `${x(row.interval[1])}%`, y1: y + 13, y2: y + 13, class: 'bar-interval' })]
      : [];
    return [bar, ...interval, name, value];
  });
  const text = rows.map((row) => `${row.label} ${row.text}`).join('; ');
  return h('div', { class: 'bars' }, svg('svg', { width: '100%', height: rows.length * ROW, role: 'img', 'aria-label': `${label}: ${text}` }, parts));
}

/** Thin bars over whole numbers: lines of a spectrum. */
export function stems({ label, rows, unit }) {
  const most = Math.max(...rows.map((row) => row.value), 1e-12);
  const last = Math.max(...rows.map((row) => row.n), 4);
  const x = (n) => 6 + (n / (last * 1.05)) * 90;
  const parts = rows.flatMap((row) => {
    const top = 96 - (row.value / most) * 78;
    return [
      svg('line', { x1: `${x(row.n)}%`, x2: `${x(row.n)}%`, y1: 96, y2: top, class: 'stem' }),
      svg('text', { x: `${x(row.n)}%`, y: top - 4, 'text-anchor': 'middle', class: 'bar-value' }, String(row.n)),
    ];
  });
  return h('figure', { class: 'stems' }, h('figcaption', { text: label }),
    svg('svg', { width: '100%', height: 116, role: 'img', 'aria-label': `${label}: ${rows.map((row) => `${row.n} per turn ${row.text}`).join(', ')}` },
      svg('line', { x1: '5%', x2: '97%', y1: 96, y2: 96, class: 'axis' }), parts,
      svg('text', { x: '97%', y: 112, 'text-anchor': 'end', class: 'bar-name' }, `lines per turn; the longest is ${unit}`)));
}
