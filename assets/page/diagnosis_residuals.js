// Residuals of every row: by joint angle, over time, as a table.

import { NONE, h, mm } from './dom.js';
import { curves } from './curves.js';
import { section } from './layout.js';
import { table } from './table.js';

const length = (flat, i) => Math.hypot(flat[3 * i], flat[3 * i + 1], flat[3 * i + 2]);

/** Rows with their distances from the model. */
export function rowsOf(residuals) {
  const joints = residuals.q_deg.length / residuals.line.length;
  return residuals.line.map((line, i) => ({
    i, line, id: residuals.id[i], t: residuals.t_min[i], outlier: residuals.outlier[i] === 1,
    q: residuals.q_deg.slice(joints * i, joints * (i + 1)), before: length(residuals.before_mm, i), after: length(residuals.after_mm, i),
  }));
}

export function residualSection(scene) {
  const all = rowsOf(scene.view.residuals);
  scene.rows = all;
  const rows = all.filter((row) => !row.outlier);
  const timed = rows.length > 0 && rows.every((row) => row.t !== null);
  const { joint: joints } = scene.view.robot;
  const spans = joints.map((_, j) => j).filter((j) => new Set(rows.map((row) => row.q[j])).size > 1);
  const plots = [
    scatter(rows, { title: timed ? 'Over time' : 'In the order of the rows', xLabel: timed ? 'minutes' : 'line of the file', of: (row) => (timed ? row.t : row.line) }, scene),
    ...spans.map((j) => {
      const slides = joints[j].type === 'prismatic';
      return scatter(rows, { title: `By the ${slides ? 'travel' : 'angle'} of joint ${j + 1}`, xLabel: slides ? 'mm' : 'deg', of: (row) => row.q[j] }, scene);
    }),
  ];
  const columns = [
    { key: 'line', label: 'line', number: true, value: (row) => row.line, text: (row) => String(row.line) },
    { key: 'id', label: 'id', value: (row) => row.id, text: (row) => row.id ?? '', class: 'name' },
    timed && { key: 't', label: 'min', number: true, value: (row) => row.t, text: (row) => (row.t === null ? NONE : String(row.t)) },
    { key: 'before', label: 'before mm', number: true, value: (row) => row.before, text: (row) => mm(row.before, 3) },
    { key: 'after', label: 'after mm', number: true, value: (row) => row.after, text: (row) => mm(row.after, 3) },
    { key: 'outlier', label: 'set aside', value: (row) => (row.outlier ? 1 : 0), text: (row) => (row.outlier ? 'false row' : '') },
  ].filter(Boolean);
  const list = table({ caption: 'Rows', name: 'rows', columns, rows: all, sort: { key: 'before', up: false }, rowClass: (row) => (row.outlier ? 'refused' : ''), onRow: (row) => scene.state.set({ row: row.i }) });
  scene.state.on('row', () => list.choose(all[scene.state.row] ?? null));
  const shown = all.length < scene.view.rows ? h('p', { class: 'notice', text: `Every ${Math.ceil(scene.view.rows / all.length)}th of ${scene.view.rows} rows is shown.` }) : null;
  return section('residuals', 'Distance from the model, row by row', 'Residuals', h('div', { class: 'plots three' }, plots.map((plot) => plot.element)), shown, list.element);
}

function scatter(rows, { title, xLabel, of }, { state }) {
  const sorted = [...rows].sort((a, b) => of(a) - of(b));
  const plot = curves({
    title, x: sorted.map(of), xLabel, yLabel: 'mm', height: 210, text: `${title}: distance from the model of ${rows.length} rows before and after`,
    series: [
      { label: 'before', colour: 'before', dots: true, size: 4, values: sorted.map((row) => row.before) },
      { label: 'after', colour: 'after', dots: true, size: 4, values: sorted.map((row) => row.after) },
    ],
    needle: () => {
      const row = rows.find((one) => one.i === state.row);
      return row ? of(row) : null;
    },
    onClick: (_, at) => state.set({ row: sorted[at].i }),
  });
  state.on('row', plot.follow);
  return plot;
}
