// Spectra of the gears: how far each joint swings, line by line, and what that is at the tool.

import { h, mm, number } from './dom.js';
import { curves } from './curves.js';
import { section } from './layout.js';
import { table } from './table.js';

const NAMES = { 1: 'eccentricity', 2: 'second harmonic' };
const LEAST_LINES = 12;
/** Of more named lines than this the largest have their number above the plot; the table has all. */
const LABELLED = 12;

/** Lines of the causes alone, where a page holds no model: sizes in rad, no lever. */
function fromCauses(causes) {
  const lines = causes.filter((cause) => cause.effect.startsWith('gear') && cause.size !== null && cause.slot !== null);
  const joints = [...new Set(lines.map((cause) => cause.joint))].sort((a, b) => a - b);
  return joints.map((joint) => ({
    joint, lever_mm: null,
    lines: lines.filter((cause) => cause.joint === joint).map((cause) => ({
      n: cause.n ?? (cause.effect === 'gear_eccentricity' ? 1 : 2), named: true, mrad: 1000 * cause.size, sigma_mrad: cause.sigma === null ? null : 1000 * cause.sigma,
    })).sort((a, b) => a.n - b.n),
  }));
}

export function gearSection(data, view) {
  const hasModel = (view.spectra ?? []).length > 0;
  const spectra = hasModel ? view.spectra : fromCauses(data.causes);
  if (spectra.length === 0) return null;
  const all = spectra.flatMap(({ joint, lever_mm: lever, lines }) => lines.map((line) => ({ joint, ...line, mm: lever === null ? null : line.mrad * lever / 1000 })));
  const size = (value, sigma) => `${value.toFixed(4)}${sigma === null ? '' : ` ± ${sigma.toFixed(4)}`}`;
  const columns = [
    { key: 'joint', label: 'joint', number: true, value: (row) => row.joint, text: (row) => String(row.joint) },
    { key: 'n', label: 'lines a turn', number: true, value: (row) => row.n, text: (row) => String(row.n) },
    { key: 'mrad', label: 'mrad', number: true, value: (row) => row.mrad, text: (row) => size(row.mrad, row.sigma_mrad) },
    { key: 'mm', label: 'mm at the tool', number: true, value: (row) => row.mm, text: (row) => mm(row.mm) },
    { key: 'named', label: 'named', value: (row) => (row.named ? 1 : 0), text: (row) => (row.named ? (NAMES[row.n] ?? `${row.n} a turn`) : '') },
  ];
  return section('gears', 'Gears: lines over a turn of each joint', 'Gears',
    h('div', { class: 'plots' }, spectra.map(spectrum)),
    h('p', { class: 'notice', 'data-name': 'gears-notice', text: hasModel
      ? 'Amplitudes of the model. A joint with three named lines or more has every line that the model fits, up to 80 a turn, which spreads what the measured part of a turn cannot tell apart; others have their named lines and overtones of them. At the tool: times the distance of the measured points from the joint’s axis, rms.'
      : 'Lines of the causes; the whole spectra and their size at the tool are on the page that `diagnose --report` writes.' }),
    table({ caption: 'Lines', name: 'gear-lines', columns, rows: all, sort: { key: 'mrad', up: false }, rowClass: (row) => (row.named ? '' : 'quiet') }).element);
}

function spectrum({ joint, lever_mm: lever, lines }) {
  const last = Math.max(...lines.map((line) => line.n), LEAST_LINES);
  const at = new Map(lines.map((line) => [line.n, line]));
  // half a line of room on both sides
  const x = [0, ...Array.from({ length: last }, (_, i) => i + 1), last + 1];
  const values = (wanted) => x.map((n) => (at.get(n)?.named === wanted ? at.get(n).mrad : null));
  const named = lines.filter((line) => line.named).sort((a, b) => b.mrad - a.mrad);
  const labelled = named.slice(0, LABELLED).sort((a, b) => a.n - b.n);
  const quiet = lines.length > named.length;
  const [largest] = [...lines].sort((a, b) => b.mrad - a.mrad);
  const atTool = lever === null ? '' : `, ${number(largest.mrad * lever / 1000)} mm at the tool`;
  return curves({
    title: `Joint ${joint}: ${lines.length} ${lines.length === 1 ? 'line' : 'lines'}, the largest ${largest.n} a turn, ${number(largest.mrad)} mrad${atTool}`,
    x, xLabel: 'lines a turn', yLabel: 'mrad', height: 230, right: lever === null ? null : { label: 'mm at the tool', factor: lever / 1000 },
    text: `Gear of joint ${joint}: ${named.map((line) => `${line.n} a turn ${line.mrad.toFixed(4)} mrad`).join(', ')}`,
    series: [
      { label: 'named', colour: 'after', bars: true, values: values(true) },
      ...(quiet ? [{ label: 'of the spectrum beside them', colour: 'bucket', bars: true, values: values(false) }] : []),
    ],
    marks: () => labelled.map((line) => ({ at: line.n, label: String(line.n) })),
  }).element;
}
