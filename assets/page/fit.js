// The page of `driftpost fit`: how it grows, every touch before and after, what the touches tell.

import { NONE, count, h, mm, number, plural, store } from './dom.js';
import { bars } from './bars.js';
import { curves } from './curves.js';
import { rowsOf, touchPlots, touchTable } from './fit_touches.js';
import { figure, figures, messages, notes, printed, record, section } from './layout.js';
import { table } from './table.js';
import { listOf } from './plain.js';

/** Which share of the settled deformation has come, by a growth law's text. */
function shareOf(growth) {
  const [law, tau] = growth.split(':');
  const lag = (t) => t / Number(tau);
  return { none: () => 1, exp: (t) => 1 - Math.exp(-lag(t)), 'two-stage': (t) => 1 - (1 + lag(t)) * Math.exp(-lag(t)) }[law] ?? (() => null);
}

const percent = (share) => `${(100 * share).toFixed(0)} %`;
/** As finely as a table of drift is written: 0.1 µm, and at 0.6 m from the joint as much. */
const sized = (one, value) => value.toFixed(one.unit === 'deg' ? 5 : 4);

function parameterTable(rows) {
  const size = (key) => ({ key, label: key, number: true, value: (row) => row[key], text: (row) => sized(row, row[key]) });
  const columns = [
    { key: 'joint', label: 'joint', number: true, value: (row) => row.joint, text: (row) => String(row.joint) },
    { key: 'parameter', label: 'parameter', value: (row) => row.parameter, text: (row) => row.parameter },
    size('value'), size('sigma'),
    { key: 'unit', label: 'unit', value: (row) => row.unit, text: (row) => row.unit },
    { key: 'told', label: 'told', number: true, value: (row) => row.told, text: (row) => percent(row.told) },
  ];
  return table({ caption: 'Parameters', name: 'parameters', columns, rows }).element;
}

export function fitted({ data, view, version }) {
  const tau = Number(data.growth.split(':')[1] ?? 0);
  const minutes = Array.from({ length: 121 }, (_, i) => (i * Math.max(tau, 10) * 6) / 120);
  const share = shareOf(data.growth);
  const told = [...data.parameters].sort((a, b) => b.told - a.told).filter((one) => one.told >= 0.2);
  const there = data.targets;
  const touches = rowsOf(data.residuals ?? []);
  const wrong = touches.filter((one) => one.looksFalse);
  const chosen = store({ row: null });
  const sections = [
    section('overview', 'Overview', 'Overview',
      data.warnings?.length > 0 && messages(data.warnings, 'warn'),
      figures(
        figure('Growth', data.growth.split(':')[0], '', `the other law has ${(100 * data.other_law).toFixed(1)} %`),
        figure('τ', tau.toFixed(1), 'min', `± ${number(data.tau_sigma_min)}`),
        figure('τ of cooling', data.tau_cool_min === null ? NONE : data.tau_cool_min.toFixed(1), 'min', data.tau_cool_min === null ? 'no stop was seen' : `± ${number(data.tau_cool_sigma_min)}`),
        figure('Touches', count(data.touches), '', `${plural(data.points.length, 'point')}${wrong.length > 0 ? `; ${count(wrong.length)} ${wrong.length === 1 ? 'looks' : 'look'} false` : ''}`),
        figure('Noise of one coordinate', mm(data.sigma_mm), 'mm'),
        there && figure('Drift at the targets', mm(there.drift_rms_mm), 'mm', 'rms, uncorrected', 'before'),
        there && figure('The table would leave', mm(there.left_rms_mm), 'mm', `rms; one shift of the work object ${mm(there.shift_left_rms_mm)}`, 'after')),
      notes(data.notes), printed(view)),
    section('curves', 'How it grows, and how far each point goes', 'Curves', h('div', { class: 'plots' },
      curves({
        title: 'Share of the settled deformation', x: minutes, xLabel: 'warm-up minute', yLabel: 'share', height: 240, text: `${data.growth}`,
        series: [{ label: `${data.growth.split(':')[0]}, τ ${tau.toFixed(1)} min`, colour: 'after', values: minutes.map(share) }],
        marks: () => data.stops.flatMap((stop) => stop.map((at) => ({ at, colour: 'bucket', dash: [3, 3] }))),
      }).element,
      ...touchPlots(touches, data, chosen),
      h('div', {}, h('h3', { text: 'Settled shift of each point, by its own touches' }),
        bars({ label: 'Settled shift', most: Math.max(...data.points.map((one) => Math.hypot(...one.settled_mm)), 1e-9), rows: data.points.map((one) => ({ label: one.point, value: Math.hypot(...one.settled_mm), text: `${mm(Math.hypot(...one.settled_mm), 3)} mm (${one.settled_mm.map((value) => mm(value, 3)).join(', ')})`, colour: 'after' })) })))),
    touches.length > 0 && section('touches', `Every touch${wrong.length > 0 ? `: ${plural(wrong.length, 'touch').replace('touchs', 'touches')} of ${count(touches.length)} ${wrong.length === 1 ? 'looks' : 'look'} false` : `: none of ${count(touches.length)} looks false`}`, 'Touches',
      h('p', { class: 'notice', text: 'Looks false: what the fit leaves of it is longer than five standard deviations, these from the middle one of all. It is set aside; where more than 15 % of the touches look false, all count: such an arm drifts in another way, or the tip is elsewhere.' }),
      touchTable(touches, chosen)),
    section('parameters', `What the touches tell: ${told.length} of ${data.parameters.length} parameters`, 'Parameters',
      told.length > 0 && bars({ label: 'Share that the data tell', most: 1, rows: told.slice(0, 16).map((one) => ({ label: `joint ${one.joint} ${one.parameter}: ${sized(one, one.value)} ± ${sized(one, one.sigma)} ${one.unit}`, value: one.told, text: percent(one.told), colour: 'after' })) }),
      parameterTable(data.parameters)),
    there && section('targets', 'At the targets', 'Targets', listOf('targets', there.each.map((one) => ({ target: one.target, 'moves by (mm)': Math.hypot(...one.drift_mm), 'known to (mm)': Math.hypot(...one.sigma_mm), 'moves x, y, z (mm)': one.drift_mm, 'sigma x, y, z (mm)': one.sigma_mm }))),
      there.next && h('p', { class: 'notice', text: `Touch next at joints ${there.next.q_deg.map((q) => q.toFixed(1)).join(', ')} deg (${there.next.at_mm.map((value) => value.toFixed(0)).join(', ')} mm): ${mm(there.next.left_rms_mm)} mm would be left.` })),
    record(view.provenance ?? [], version),
  ].map((one) => () => one);
  return { kind: 'fit of a warm-up', verdict: `${data.growth.split(':')[0]}, τ ${tau.toFixed(1)} min`, tone: wrong.length > 0 ? 'warn' : 'good', sections };
}
