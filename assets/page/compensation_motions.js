// The table of motions, and sums of routines where there are too many.

import { count, h, mm } from './dom.js';
import { choice } from './controls.js';
import { section } from './layout.js';
import { table } from './table.js';
import { nameOf } from './target_card.js';

const text = (value) => (value === null || value === undefined ? '' : String(value));
const figure = (key, label, decimals = 4) => ({ key, label, number: true, value: (row) => row[key], text: (row) => mm(row[key], decimals) });

/** A figure of those that are corrected. */
const corrected = (column) => {
  const of = (row) => (row.status === 'compensated' ? row : {});
  return { ...column, value: (row) => column.value(of(row)), text: (row) => column.text(of(row)) };
};

export function motionSection(scene) {
  const { data, view, course, state } = scene;
  const severalFiles = new Set(data.motions.map((motion) => motion.file)).size > 1;
  const columns = [
    { key: 'target', label: 'target', value: (row) => row.target ?? row.line, text: (row) => nameOf(row), class: 'name' },
    severalFiles && { key: 'file', label: 'file', value: (row) => row.file, text: (row) => text(row.file), class: 'name' },
    { key: 'line', label: 'line', number: true, value: (row) => row.line, text: (row) => text(row.line) },
    { key: 'routine', label: 'routine', value: (row) => row.routine, text: (row) => text(row.routine), class: 'name' },
    { key: 'kind', label: 'move', value: (row) => row.kind, text: (row) => text(row.kind) },
    { key: 'status', label: 'status', value: (row) => row.status, text: (row) => (row.status === 'compensated' ? text(row.form) : `${row.status}: ${text(row.reason)}`), class: 'reason' },
    corrected(figure('max_correction_mm', 'correction mm')), corrected(figure('max_correction_deg', 'deg', 5)),
    figure('mid_path_mm', 'mid-path mm'), figure('before_mm', 'before mm'), figure('after_mm', 'after mm'),
  ].filter(Boolean);
  const order = { refused: 0, kept: 1, compensated: 2 };
  const rows = [...data.motions].sort((a, b) => order[a.status] - order[b.status]);
  const points = new Map();
  course?.points.motion.forEach((index, i) => { if (!points.has(index)) points.set(index, i); });
  const list = table({
    caption: 'Motions', name: 'motions', columns, rows, empty: 'the program has no motion',
    rowClass: (row) => row.status, onRow: course ? choose : undefined,
  });
  function choose(row) {
    const point = points.get(row.index);
    if (point !== undefined) state.set({ point });
    list.choose(row);
  }
  if (course) state.on('point', () => list.choose(scene.motions.get(course.points.motion[state.point]) ?? null));
  return section('motions', 'Motions', 'Motions', list.element, view.routines && routines(view.routines));
}

function routines(rows) {
  const columns = [
    { key: 'routine', label: 'routine', value: (row) => row.routine, text: (row) => text(row.routine), class: 'name' },
    { key: 'file', label: 'file', value: (row) => row.file, text: (row) => text(row.file), class: 'name' },
    { key: 'motions', label: 'motions', number: true, value: (row) => row.motions, text: (row) => count(row.motions) },
    { key: 'compensated', label: 'compensated', number: true, value: (row) => row.compensated, text: (row) => count(row.compensated) },
    figure('max_correction_mm', 'largest correction mm'), figure('before_mm', 'before mm'), figure('after_mm', 'after mm'),
  ];
  return h('div', {}, h('h3', { text: 'All motions by routine' }), table({ caption: 'Routines', name: 'routines', columns, rows }).element);
}
