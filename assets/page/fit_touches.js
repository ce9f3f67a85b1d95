// Every touch of a warm-up: how far the tool had moved, and what the fit leaves of it, over time and point by point.

import { mm, number } from './dom.js';
import { curves } from './curves.js';
import { table } from './table.js';

export const rowsOf = (residuals) => residuals.map((one, i) => ({
  i, line: one.line, point: one.point, t: one.t_min, before: Math.hypot(...one.before_mm), after: Math.hypot(...one.after_mm), of: one.after_mm, looksFalse: one.looks_false, counts: one.counts,
}));

/** Two pictures of the same touches. */
export function touchPlots(rows, data, chosen) {
  if (rows.length === 0) return [];
  const stops = data.stops.map(([from, to]) => ({ at: from, to, shade: 'shade', colour: 'bucket', dash: [3, 3], label: `stands ${number(to - from)} min` }));
  const names = data.points.map((one) => one.point);
  const [first, last] = [rows[0].t, rows.at(-1).t];
  // each point is a strip of its own, its touches in the order of time
  const strip = (row) => names.indexOf(row.point) + 1 + 0.7 * ((row.t - first) / Math.max(last - first, 1e-9) - 0.5);
  return [
    scatter(rows, chosen, { title: 'Every touch over time', xLabel: 'warm-up minute', x: (row) => row.t, marks: () => stops }),
    scatter(rows, chosen, { title: 'Every touch by point, in each from the first to the last', xLabel: 'point', x: strip, names: ['', ...names, ''] }),
  ];
}

function scatter(rows, chosen, { title, xLabel, x, marks, names }) {
  const sorted = [...rows].sort((a, b) => x(a) - x(b));
  const some = rows.some((row) => row.looksFalse);
  const values = (of) => sorted.map((row) => of(row) ?? null);
  const plot = curves({
    title, x: sorted.map(x), xLabel, yLabel: 'mm', height: 240, marks, names,
    text: `${title}: ${rows.length} touches, ${mm(Math.max(...rows.map((row) => row.before)), 3)} mm at most before, ${mm(Math.max(...rows.map((row) => row.after)), 3)} mm after; ${rows.filter((row) => row.looksFalse).map((row) => `line ${row.line} looks false`).join(', ')}`,
    series: [
      { label: 'moved since the cold arm', colour: 'before', dots: true, size: 5, values: values((row) => row.before) },
      { label: 'left by the fit', colour: 'after', dots: true, size: 5, values: values((row) => (row.looksFalse ? null : row.after)) },
      ...(some ? [{ label: 'left, looks false', colour: 'bad', dots: true, size: 10, values: values((row) => (row.looksFalse ? row.after : null)) }] : []),
    ],
    needle: () => {
      const row = rows.find((one) => one.i === chosen.row);
      return row ? x(row) : null;
    },
    onClick: (_, at) => chosen.set({ row: sorted[at].i }),
  });
  chosen.on('row', plot.follow);
  return plot.element;
}

export function touchTable(rows, chosen) {
  const columns = [
    { key: 'line', label: 'line', number: true, value: (row) => row.line, text: (row) => String(row.line) },
    { key: 'point', label: 'point', value: (row) => row.point, text: (row) => row.point, class: 'name' },
    { key: 't', label: 'min', number: true, value: (row) => row.t, text: (row) => number(row.t) },
    { key: 'before', label: 'moved mm', number: true, value: (row) => row.before, text: (row) => mm(row.before) },
    { key: 'after', label: 'left mm', number: true, value: (row) => row.after, text: (row) => mm(row.after) },
    { key: 'of', label: 'left x, y, z', value: (row) => row.after, text: (row) => row.of.map((value) => mm(value, 3)).join(', ') },
    { key: 'false', label: 'judged', value: (row) => (row.looksFalse ? 1 : 0), text: (row) => (row.looksFalse ? `looks false${row.counts ? '' : ', set aside'}` : '') },
  ];
  const list = table({ caption: 'Touches', name: 'touches', columns, rows, sort: { key: 'after', up: false }, rowClass: (row) => (row.looksFalse ? 'refused' : ''), onRow: (row) => chosen.set({ row: row.i }) });
  chosen.on('row', () => list.choose(rows[chosen.row] ?? null));
  return list.element;
}
