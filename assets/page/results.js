// Pages of accuracy, compare-measurements and closed-loop: figures first, then pictures, then tables.

import { count, h, mm, number, plural } from './dom.js';
import { bars } from './bars.js';
import { causeName } from './diagnosis.js';
import { figure, figures, messages, notes, printed, record, section } from './layout.js';
import { ordered } from './parts.js';
import { listOf } from './plain.js';

const CAUSE = ['effect', 'joint', 'posterior', 'size', 'sigma', 'unit', 'rms_mm', 'evidence_nats', 'source'];

const nameOf = (pose) => pose.pose_id ?? pose.id ?? `line ${pose.line}`;

/** Go or no go as the command says it; older files tell only whether a limit was exceeded. */
function judged({ verdict, within }) {
  if (verdict) return { verdict, tone: within === true ? 'good' : 'bad' };
  if (verdict === undefined && within === false) return { verdict: 'NO GO: beyond a limit', tone: 'bad' };
  return { verdict: verdict === null ? 'Measured; no limit was given' : 'No limit was exceeded', tone: '' };
}

/** What a result warns of, then what it says beside its lists. */
const opening = (data) => [data.warnings?.length > 0 && messages(data.warnings, 'warn'), notes(data.notes)];

/** Columns of an orientation, where it was measured. */
const angles = (of, abc) => (abc ? Object.fromEntries(['a', 'b', 'c'].map((axis, i) => [`${of} ${axis} (deg)`, abc[i]])) : {});

const limitRow = (one) => ({ limit: one.limit, 'at most (mm)': one.limit_mm, 'worst (mm)': one.worst_mm, verdict: one.verdict, poses: one.poses, 'poses needed': one.poses_needed });

/** Poses at several times: what AP and RP were at each. */
const timeRows = (data) => data.poses.filter((pose) => pose.times?.length > 1).flatMap((pose) => pose.times.map((one) => ({ pose: nameOf(pose), minute: one.t_min, 'AP (mm)': one.ap_mm, 'RP (mm)': one.rp_mm })));

export function accuracy({ data, view, version }) {
  const { worst } = data;
  const poses = data.poses.map((pose) => ({
    pose: nameOf(pose), line: pose.line, 'AP mm': pose.ap_mm, 'RP mm': pose.repeatability?.rp_mm ?? null, n: pose.repeatability?.n ?? 1,
    'AP x (mm)': pose.ap_xyz_mm?.[0] ?? null, 'AP y (mm)': pose.ap_xyz_mm?.[1] ?? null, 'AP z (mm)': pose.ap_xyz_mm?.[2] ?? null,
    'drift of AP mm': pose.drift_ap_mm, 'drift of RP mm': pose.drift_rp_mm, ...angles('AP', pose.ap_abc_deg), ...angles('RP', pose.rp_abc_deg), joints: pose.q_deg.map((q) => q.toFixed(1)).join(', '),
  }));
  const times = timeRows(data);
  const most = Math.max(...data.poses.map((pose) => pose.ap_mm), 1e-9);
  const sections = [
    section('overview', 'Overview', 'Overview',
      figures(
        figure('Pose accuracy AP', mm(worst.ap_mm), 'mm', 'the worst pose'), figure('Repeatability RP', mm(worst.rp_mm), 'mm', 'the worst pose'),
        figure('Drift of AP', mm(worst.drift_ap_mm), 'mm', 'the worst pose'), figure('Poses', count(data.poses.length)),
        data.multi_directional_mm !== null && figure('Multi-directional', mm(data.multi_directional_mm), 'mm')),
      opening(data),
      data.lines_left_out?.length > 0 && h('p', { class: 'notice', text: `Not judged: ${plural(data.lines_left_out.length, 'row')}, ${data.lines_left_out.length === 1 ? 'line' : 'lines'} ${data.lines_left_out.join(', ')}` }),
      data.limits?.length > 0 && [h('h3', { class: 'apart', text: 'Limits' }), listOf('limits', data.limits.map(limitRow))],
      printed(view)),
    section('poses', 'Pose by pose', 'Poses',
      bars({ label: 'Pose accuracy', most, rows: [...data.poses].sort((a, b) => b.ap_mm - a.ap_mm).slice(0, 12).map((pose) => ({ label: nameOf(pose), value: pose.ap_mm, text: `AP ${mm(pose.ap_mm)} mm${pose.repeatability ? `, RP ${mm(pose.repeatability.rp_mm)} mm` : ''}`, colour: 'after' })) }),
      listOf('poses', poses)),
    times.length > 0 && section('times', 'Over time, pose by pose', 'Times', listOf('times', times)),
    record(view.provenance ?? [], version),
  ].map((one) => () => one);
  return { kind: 'ISO 9283', ...judged(data), sections };
}

export function comparison({ data, view, version }) {
  const tools = data.tools.map((one, i) => ({ reflector: i + 1, 'moved by (mm)': Math.hypot(...one.by_mm), 'x (mm)': one.by_mm[0], 'y (mm)': one.by_mm[1], 'z (mm)': one.by_mm[2], 'sigma (mm)': one.sigma_mm }));
  const sections = [
    section('overview', 'Overview', 'Overview',
      figures(
        figure('The points have moved by', mm(data.rms_mm), 'mm', data.noise_rms_mm === null ? 'rms, base and tool refitted' : `rms; noise alone would be ${mm(data.noise_rms_mm)}`, 'before'),
        figure('Poses in both', count(data.pairs), '', `${data.alone[0]} only before, ${data.alone[1]} only after`),
        figure('Base and instrument', mm(Math.hypot(...data.base.by_mm), 3), 'mm', `${data.base.by_mm.map((value) => value.toFixed(3)).join(', ')}; turned by ${number(data.base.turned_deg)} deg`),
        data.beyond_noise !== undefined && figure('Beyond the noise', count(data.beyond_noise), '', 'poses', data.beyond_noise > 0 ? 'before' : '')),
      opening(data), printed(view)),
    tools.length > 0 && section('tools', 'The tool', 'Tool', listOf('tools', tools)),
    data.causes.length > 0 && section('causes', 'What has changed', 'Causes', bars({ label: 'Probability', most: 1, rows: data.causes.slice(0, 12).map((cause) => ({ label: causeName(cause), value: cause.posterior, text: `${(100 * cause.posterior).toFixed(1)} %`, colour: 'after' })) }), listOf('causes', data.causes.map((one) => ordered(one, CAUSE)))),
    data.worst.length > 0 && section('worst', 'Poses that have moved most', 'Poses', listOf('worst', data.worst.map((one) => ({ 'line before': one.line_before, 'line after': one.line_after, 'moved (mm)': one.mm })))),
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
      h('p', { class: 'reason', text: `Injected: ${data.withheld}.` }),
      notes(data.notes),
      figures(
        figure('Truly, before', mm(before.true_rms_mm), 'mm', `rms of ${plural(data.targets, 'target')}; ${mm(before.true_max_mm)} at worst`, 'before'),
        figure('Truly, after', mm(after.true_rms_mm), 'mm', `rms; ${mm(after.true_max_mm)} at worst`, 'after'),
        figure('Noise floor', mm(data.floor_rms_mm), 'mm', data.limit_of_floor ? `rms in space; ${number(data.limit_of_floor)} times as much is allowed` : 'rms in space'),
        data.kept > 0 && figure('Kept uncorrected', plural(data.kept, 'motion'), '', '', 'before'), figure('Verdict', data.verdict.replaceAll('_', ' '))),
      bars({
        label: 'Errors before and after', most,
        rows: [row('before, at worst', before.true_max_mm, 'before'), row('before, rms', before.true_rms_mm, 'before'), row('after, at worst', after.true_max_mm, 'after'), row('after, rms', after.true_rms_mm, 'after'), row('noise of the measurement', data.floor_rms_mm, 'plain')],
      }),
      printed(view)),
    data.causes.length > 0 && section('causes', 'What was found', 'Causes', listOf('causes', data.causes.map((cause) => (typeof cause === 'string' ? { cause } : cause)))),
    record(view.provenance ?? [], version),
  ].map((one) => () => one);
  const within = data.within === undefined ? '' : `: ${data.within ? 'within' : 'NOT within'} ${number(data.limit_of_floor)} times the noise floor`;
  const better = after.true_rms_mm < before.true_rms_mm ? 'good' : 'warn';
  return { kind: 'closed loop', verdict: `${mm(before.true_rms_mm)} mm before, ${mm(after.true_rms_mm)} mm after${within}`, tone: data.within === false ? 'bad' : better, sections };
}
