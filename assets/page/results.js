// Pages of simulate, fit, accuracy, compare-measurements and closed-loop: figures first, then pictures, then tables.

import { count, h, mm, number, plural } from './dom.js';
import { bars } from './bars.js';
import { curves } from './curves.js';
import { causeName } from './diagnosis.js';
import { figure, figures, later, nameOfFile, record, section } from './layout.js';
import { listOf } from './plain.js';

const printed = (view) => view.text && later('The report as printed', () => h('pre', { class: 'report', tabIndex: 0, text: view.text }));

/** Lists of the JSON as tables, those that hold anything. */
const lists = (data, names) => Object.entries(names).filter(([key]) => data[key]?.length > 0)
  .map(([key, title]) => section(`list-${key}`, `${title}: ${count(data[key].length)}`, title, listOf(key, data[key])));

/** The keys that matter in their order; the others are left to the JSON. */
const ordered = (row, keys) => Object.fromEntries(keys.filter((key) => key in row).map((key) => [key, row[key]]));

const CAUSE = ['effect', 'joint', 'posterior', 'size', 'sigma', 'unit', 'rms_mm', 'evidence_nats', 'source'];

const shortFile = (row) => ({ ...row, file: row.file ? nameOfFile(row.file) : row.file });

export function simulation({ data, view, version }) {
  const passes = data.minutes;
  const worst = data.worst;
  const t = passes.map((pass) => pass.t_min);
  const max = (of) => passes.reduce((most, pass) => Math.max(most, of(pass) ?? 0), 0);
  const one = passes.length === 1;
  const series = [
    { label: 'original', colour: 'before', dots: one, values: passes.map((pass) => pass.before.max_mm) },
    { label: 'as executed', colour: 'after', dots: one, values: passes.map((pass) => pass.after.max_mm) },
    { label: 'path between targets, as executed', colour: 'claim', dots: one, values: passes.map((pass) => pass.path_after_mm) },
  ];
  const sorted = t.every((value, i) => i === 0 || value >= t[i - 1]);
  const rows = passes.map((pass) => ({
    t_min: pass.t_min, motions: pass.n, 'before max (mm)': pass.before.max_mm, 'before rms (mm)': pass.before.rms_mm, 'after max (mm)': pass.after.max_mm,
    'after rms (mm)': pass.after.rms_mm, 'path (mm)': pass.path_after_mm, unreached: pass.unreached, failure: pass.failure, mismatch: pass.mismatch,
  }));
  const failed = passes.some((pass) => pass.failure || pass.mismatch);
  const sections = [
    section('overview', 'Overview', 'Overview',
      figures(
        figure('Worst error of the original', mm(max((pass) => pass.before.max_mm)), 'mm', 'on the deformed robot', 'before'),
        figure('Worst error as executed', mm(max((pass) => pass.after.max_mm)), 'mm', worst && `minute ${number(worst.t_min)}, ${nameOfFile(worst.file)}:${worst.line}`, 'after'),
        figure('Motions executed', count(data.executed.motions), '', `of ${count(data.executed.of)} in the program`),
        figure(one ? 'Minute' : 'Passes', one ? number(t[0]) : count(passes.length)),
        data.switches.length > 0 && figure('Largest step at a switch', mm(Math.max(...data.switches.map((one_) => one_.jump_mm))), 'mm', plural(data.switches.length, 'switch').replace('switchs', 'switches'))),
      printed(view)),
    passes.length > 0 && section('curves', 'Errors at each minute', 'Curves',
      curves({ title: 'Worst error of the TCP', x: sorted ? t : passes.map((_, i) => i + 1), xLabel: sorted ? 'warm-up minute' : 'pass', yLabel: 'mm', height: 300, series, text: `Worst error as executed ${mm(max((pass) => pass.after.max_mm))} mm` }).element,
      listOf('passes', rows)),
    ...lists({ ...data, switches: data.switches.map((one_) => ordered(one_, ['t_min', 'jump_mm'])), functions: data.functions.map((one_) => ordered(one_, ['name', 'calls', 'statements', 'arithmetic', 'trigonometric'])), messages: data.messages.map(shortFile), unchanged: data.unchanged.map(shortFile) }, { switches: 'Switches', unchanged: 'Motions not corrected', messages: 'Messages', unknown_instructions: 'Unknown instructions', functions: 'Functions' }),
    record(view.provenance ?? [], version),
  ].map((one) => () => one);
  return { kind: 'simulation', verdict: `${plural(data.executed.motions, 'motion')} executed: ${mm(max((pass) => pass.after.max_mm))} mm at worst`, tone: failed || data.executed.motions === 0 ? 'bad' : 'good', sections };
}

/** Which share of the settled deformation has come, by a growth law's text. */
function shareOf(growth) {
  const [law, tau] = growth.split(':');
  const lag = (t) => t / Number(tau);
  return { none: () => 1, exp: (t) => 1 - Math.exp(-lag(t)), 'two-stage': (t) => 1 - (1 + lag(t)) * Math.exp(-lag(t)) }[law] ?? (() => null);
}

export function fitted({ data, view, version }) {
  const tau = Number(data.growth.split(':')[1] ?? 0);
  const minutes = Array.from({ length: 121 }, (_, i) => (i * Math.max(tau, 10) * 6) / 120);
  const share = shareOf(data.growth);
  const told = [...data.parameters].sort((a, b) => b.told - a.told).filter((one) => one.told >= 0.2);
  const there = data.targets;
  const sections = [
    section('overview', 'Overview', 'Overview',
      figures(
        figure('Growth', data.growth.split(':')[0], '', `the other law has ${(100 * data.other_law).toFixed(1)} %`),
        figure('τ', tau.toFixed(1), 'min', `± ${number(data.tau_sigma_min)}`),
        figure('τ of cooling', data.tau_cool_min === null ? '–' : data.tau_cool_min.toFixed(1), 'min', data.tau_cool_min === null ? 'no stop was seen' : `± ${number(data.tau_cool_sigma_min)}`),
        figure('Touches', count(data.touches), '', plural(data.points.length, 'point')),
        figure('Noise of one coordinate', mm(data.sigma_mm), 'mm'),
        there && figure('Drift at the targets', mm(there.drift_rms_mm), 'mm', 'rms, uncorrected', 'before'),
        there && figure('The table would leave', mm(there.left_rms_mm), 'mm', `rms; one shift of the work object ${mm(there.shift_left_rms_mm)}`, 'after')),
      printed(view)),
    section('curves', 'How it grows, and how far each point goes', 'Curves', h('div', { class: 'plots' },
      curves({
        title: 'Share of the settled deformation', x: minutes, xLabel: 'warm-up minute', yLabel: 'share', height: 240, text: `${data.growth}`,
        series: [{ label: `${data.growth.split(':')[0]}, τ ${tau.toFixed(1)} min`, colour: 'after', values: minutes.map(share) }],
        marks: () => data.stops.flatMap((stop) => stop.map((at) => ({ at, colour: 'bucket', dash: [3, 3] }))),
      }).element,
      h('div', {}, h('h3', { text: 'Settled shift of each point, by its own touches' }),
        bars({ label: 'Settled shift', most: Math.max(...data.points.map((one) => Math.hypot(...one.settled_mm)), 1e-9), rows: data.points.map((one) => ({ label: one.point, value: Math.hypot(...one.settled_mm), text: `${mm(Math.hypot(...one.settled_mm), 3)} mm (${one.settled_mm.map((value) => mm(value, 3)).join(', ')})`, colour: 'after' })) })))),
    section('parameters', `What the touches tell: ${told.length} of ${data.parameters.length} parameters`, 'Parameters',
      told.length > 0 && bars({ label: 'Share that the data tell', most: 1, rows: told.slice(0, 16).map((one) => ({ label: `joint ${one.joint} ${one.parameter}: ${number(one.value)} ± ${number(one.sigma)} ${one.unit}`, value: one.told, text: `${(100 * one.told).toFixed(0)} % told by the data`, colour: 'after' })) }),
      listOf('parameters', data.parameters.map((one) => ordered(one, ['joint', 'parameter', 'value', 'sigma', 'unit', 'told'])))),
    there && section('targets', 'At the targets', 'Targets', listOf('targets', there.each),
      there.next && h('p', { class: 'notice', text: `Touch next at joints ${there.next.q_deg.map((q) => q.toFixed(1)).join(', ')} deg (${there.next.at_mm.map((value) => value.toFixed(0)).join(', ')} mm): ${mm(there.next.left_rms_mm)} mm would be left.` })),
    record(view.provenance ?? [], version),
  ].map((one) => () => one);
  return { kind: 'fit of a warm-up', verdict: `${data.growth.split(':')[0]}, τ ${tau.toFixed(1)} min`, tone: 'good', sections };
}

export function accuracy({ data, view, version }) {
  const { worst } = data;
  const poses = data.poses.map((pose, i) => ({
    pose: pose.id ?? `line ${pose.line}`, line: pose.line, 'AP mm': pose.ap_mm, 'RP mm': pose.repeatability?.rp_mm ?? null, n: pose.repeatability?.n ?? 1,
    'drift of AP mm': pose.drift_ap_mm, 'drift of RP mm': pose.drift_rp_mm, joints: pose.q_deg.map((q) => q.toFixed(1)).join(', '),
  }));
  const most = Math.max(...data.poses.map((pose) => pose.ap_mm), 1e-9);
  const sections = [
    section('overview', 'Overview', 'Overview',
      figures(
        figure('Pose accuracy AP', mm(worst.ap_mm), 'mm', 'the worst pose'), figure('Repeatability RP', mm(worst.rp_mm), 'mm', 'the worst pose'),
        figure('Drift of AP', mm(worst.drift_ap_mm), 'mm', 'the worst pose'), figure('Poses', count(data.poses.length)),
        data.multi_directional_mm !== null && figure('Multi-directional', mm(data.multi_directional_mm), 'mm')),
      printed(view)),
    section('poses', 'Pose by pose', 'Poses',
      bars({ label: 'Pose accuracy', most, rows: [...data.poses].sort((a, b) => b.ap_mm - a.ap_mm).slice(0, 12).map((pose) => ({ label: pose.id ?? `line ${pose.line}`, value: pose.ap_mm, text: `AP ${mm(pose.ap_mm)} mm${pose.repeatability ? `, RP ${mm(pose.repeatability.rp_mm)} mm` : ''}`, colour: 'after' })) }),
      listOf('poses', poses)),
    record(view.provenance ?? [], version),
  ].map((one) => () => one);
  return { kind: 'ISO 9283', verdict: data.within ? 'Within every limit that was given' : 'NO GO: beyond a limit', tone: data.within ? 'good' : 'bad', sections };
}

export function comparison({ data, view, version }) {
  const tools = data.tools.map((one, i) => ({ reflector: i + 1, 'moved by (mm)': Math.hypot(...one.by_mm), x: one.by_mm[0], y: one.by_mm[1], z: one.by_mm[2], 'sigma (mm)': one.sigma_mm }));
  const sections = [
    section('overview', 'Overview', 'Overview',
      figures(
        figure('The points have moved by', mm(data.rms_mm), 'mm', data.noise_rms_mm === null ? 'rms, base and tool refitted' : `rms; noise alone would be ${mm(data.noise_rms_mm)}`, 'before'),
        figure('Poses in both', count(data.pairs), '', `${data.alone[0]} only before, ${data.alone[1]} only after`),
        figure('Base and instrument', mm(Math.hypot(...data.base.by_mm), 3), 'mm', `turned by ${number(data.base.turned_deg)} deg`)),
      printed(view)),
    tools.length > 0 && section('tools', 'The tool', 'Tool', listOf('tools', tools)),
    data.causes.length > 0 && section('causes', 'What has changed', 'Causes', bars({ label: 'Probability', most: 1, rows: data.causes.slice(0, 12).map((cause) => ({ label: causeName(cause), value: cause.posterior, text: `${(100 * cause.posterior).toFixed(1)} %`, colour: 'after' })) }), listOf('causes', data.causes.map((one) => ordered(one, CAUSE)))),
    data.worst.length > 0 && section('worst', 'Poses that have moved most', 'Poses', listOf('worst', data.worst.map((one) => ordered(one, ['line_before', 'line_after', 'mm'])))),
    record(view.provenance ?? [], version),
  ].map((one) => () => one);
  return { kind: 'comparison of two measurements', verdict: data.changed ? 'Changed' : 'Not changed', tone: data.changed ? 'warn' : 'good', sections };
}

export function closedLoop({ data, view, version }) {
  const { before, after } = data;
  const most = Math.max(before.true_max_mm, after.true_max_mm);
  const row = (label, value, colour) => ({ label, value, text: `${mm(value)} mm`, colour });
  const sections = [
    section('overview', 'Overview', 'Overview',
      h('p', { class: 'reason', text: `Injected: ${data.withheld}. ${view.text ? `Found: ${view.text}.` : ''}` }),
      figures(
        figure('Truly, before', mm(before.true_rms_mm), 'mm', `rms of ${plural(data.targets, 'target')}; ${mm(before.true_max_mm)} at worst`, 'before'),
        figure('Truly, after', mm(after.true_rms_mm), 'mm', `rms; ${mm(after.true_max_mm)} at worst`, 'after'),
        figure('Noise floor', mm(data.floor_rms_mm), 'mm', 'rms in space'), figure('Verdict', data.verdict.replaceAll('_', ' '))),
      bars({
        label: 'Errors before and after', most,
        rows: [row('before, at worst', before.true_max_mm, 'before'), row('before, rms', before.true_rms_mm, 'before'), row('after, at worst', after.true_max_mm, 'after'), row('after, rms', after.true_rms_mm, 'after'), row('noise of the measurement', data.floor_rms_mm, 'plain')],
      })),
    data.causes.length > 0 && section('causes', 'What was found', 'Causes', listOf('causes', data.causes.map((cause) => (typeof cause === 'string' ? { cause } : cause)))),
    record(view.provenance ?? [], version),
  ].map((one) => () => one);
  return { kind: 'closed loop', verdict: `${mm(before.true_rms_mm)} mm before, ${mm(after.true_rms_mm)} mm after`, tone: after.true_rms_mm < before.true_rms_mm ? 'good' : 'warn', sections };
}
