// The page of `driftpost diagnose`.

import { NONE, count, h, measured, mm, number, plural, store } from './dom.js';
import { bars } from './bars.js';
import { figure, figures, messages, notes, printed, record, section } from './layout.js';
import { table } from './table.js';
import { residualSection } from './diagnosis_residuals.js';
import { nextSection, poseSection } from './diagnosis_arm.js';
import { gearSection } from './diagnosis_gears.js';

const VERDICTS = {
  explained: ['good', 'One cause, told apart from its rivals'], several: ['good', 'Several causes, each needed'],
  ambiguous: ['warn', 'A cause is there; these data cannot tell which of a set'], geometry: ['good', 'Small errors of all joints, none singled out'],
  unexplained_structure: ['warn', 'Structure that no effect of the library takes'], unexplained_scatter: ['warn', 'More scatter than the repeats allow'],
  nothing_above_noise: ['good', 'Nothing above the noise'], insufficient_data: ['bad', 'Too few or too alike poses for any answer'],
  data_fault: ['bad', 'The file contradicts itself or the robot'],
};
const NAMED = new Set(['explained', 'several', 'ambiguous', 'data_fault']);

const words = (effect) => effect.replaceAll('_', ' ');

export function causeName(cause) {
  const joint = cause.joint ? ` of joint ${cause.joint}` : '';
  const other = cause.joint_b ? ` on joint ${cause.joint_b}` : '';
  const n = cause.n && cause.effect === 'gear_mesh' ? `, ${cause.n} per turn` : '';
  const when = cause.t0_min !== null && cause.t0_min !== undefined ? ` at minute ${number(cause.t0_min)}` : '';
  return `${words(cause.effect)}${joint}${other}${n}${when}`;
}

const percent = (p) => (p > 0.999 ? '> 99.9 %' : p < 0.001 ? '< 0.1 %' : `${(100 * p).toFixed(1)} %`);
const size = (cause) => (cause.size === null ? NONE : `${cause.sigma === null ? number(cause.size) : measured(cause.size, cause.sigma)} ${cause.unit === '1' ? '' : cause.unit}`);

export function diagnosis({ data, view, version }) {
  const [tone, verdict] = VERDICTS[data.verdict] ?? ['', words(data.verdict)];
  const scene = { data, view, state: store({ row: null, pose: null, after: false, times: 100 }) };
  const hasRows = (view.residuals?.line.length ?? 0) > 0;
  const sections = [
    () => overview(data, view, tone),
    () => causeSection(data),
    () => gearSection(data, view),
    () => hasRows && residualSection(scene),
    () => view.robot && (hasRows || data.next_measurements.length > 0) && poseSection(scene),
    () => !view.robot && nextSection(scene),
    () => data.false_rows?.length > 0 && falseSection(data),
    () => limitSection(data),
    () => record([...(view.provenance ?? []), ...(view.robot ? [['robot', view.robot.name]] : [])], version),
  ];
  return { kind: 'diagnosis', verdict, tone, sections };
}

function overview(data, view, tone) {
  const { shrink, noise } = data;
  const rows = [
    { label: 'before', value: shrink.before_rms_mm, text: `${mm(shrink.before_rms_mm, 3)} mm`, colour: 'before' },
    shrink.causes_only_rms_mm !== null && { label: 'causes alone', value: shrink.causes_only_rms_mm, text: `${mm(shrink.causes_only_rms_mm, 3)} mm`, colour: 'plain' },
    {
      label: 'with the model', value: shrink.after_rms_mm, text: `${mm(shrink.after_rms_mm, 3)} mm`, colour: 'after',
      interval: shrink.ci90 && shrink.ci90.map((ratio) => ratio * shrink.before_rms_mm),
    },
    { label: 'noise', value: shrink.floor_rms_mm, text: `${mm(shrink.floor_rms_mm, 3)} mm`, colour: 'plain' },
  ].filter(Boolean);
  const blocks = [['last part of the time', shrink.time_block], ['a region of the workspace', shrink.region_block]].filter(([, block]) => block);
  const most = Math.max(...rows.map((row) => row.interval?.[1] ?? 0), ...rows.map((row) => row.value));
  return section('overview', 'Verdict', 'Verdict',
    h('p', { class: `reason ${tone}`, text: sentence(data.reason) }),
    view.mostly && h('p', { class: 'notice', 'data-name': 'mostly', text: view.mostly }),
    view.next && h('p', { class: 'next', 'data-name': 'next-step' }, h('b', { text: 'Next: ' }), `${view.next}.`),
    view.from_json && notes(data.notes),
    data.fault && messages([{ code: 'data fault', message: typeof data.fault === 'string' ? data.fault : Object.values(data.fault).map(String).join('; ') }], 'bad'),
    data.warnings.length > 0 && messages(data.warnings, 'warn'),
    figures(
      figure('Rows', count(data.rows), '', plural(data.stations, 'station')),
      shrink.ratio !== null && figure(shrink.ratio > 1 ? 'The gap grows to' : 'The gap shrinks to', `${(100 * shrink.ratio).toFixed(0)} %`, '', shrink.ci90 && `${(100 * shrink.ci90[0]).toFixed(0)} to ${(100 * shrink.ci90[1]).toFixed(0)} %, nine times in ten`, 'after'),
      noise?.repeats_sigma_mm !== undefined && noise.repeats_sigma_mm !== null && figure('Noise in repeats', mm(noise.repeats_sigma_mm), 'mm', 'of one coordinate'),
      noise?.shared_sigma_mm !== undefined && noise.shared_sigma_mm !== null && figure('Shared by the targets of a pose', mm(noise.shared_sigma_mm), 'mm', 'where the arm stood: a pose tells once'),
      noise?.model_sigma_mm !== undefined && noise.model_sigma_mm !== null && figure('Noise about the best model', mm(noise.model_sigma_mm), 'mm', noise.repeats_sigma_mm === null ? 'of one coordinate; nothing was repeated, so this cannot be checked' : 'of one coordinate'),
      data.where?.joint && figure('Where', `joint ${data.where.joint}`, '', data.where.time ?? undefined),
    ),
    shrink.before_rms_mm !== null && [h('h3', { class: 'apart', text: 'How much better the robot gets, on poses held out (rms, 3-D)' }), bars({ label: 'Error on held-out poses', rows, most })],
    blocks.map(([name, block]) => h('p', { class: 'calm', text: `${name} held out whole: ${mm(block.before_rms_mm, 3)} mm before, ${mm(block.after_rms_mm, 3)} mm after` })),
    view.from_json && h('p', { class: 'notice', text: 'Made from JSON alone: residuals and the arm are on the page that `diagnose --report` writes.' }),
    printed(view));
}

const sentence = (text) => (text ? text[0].toUpperCase() + text.slice(1) + (text.endsWith('.') ? '' : '.') : '');

function causeSection(data) {
  const named = NAMED.has(data.verdict);
  const title = named ? 'Causes' : 'Nearest candidates, none of them the answer';
  if (data.causes.length === 0) return section('causes', 'Causes', 'Causes', h('p', { class: 'calm', text: 'No cause is named.' }));
  const columns = [
    { key: 'name', label: 'effect', value: causeName, text: causeName, class: 'name' },
    { key: 'posterior', label: 'probability', number: true, value: (c) => c.posterior, text: (c) => percent(c.posterior) },
    { key: 'size', label: 'size', number: true, value: (c) => c.size, text: size },
    { key: 'rms', label: 'tool moves, mm', number: true, value: (c) => c.rms_mm, text: (c) => mm(c.rms_mm, 3) },
    { key: 'seen', label: 'of it seen, mm', number: true, value: (c) => c.rms_seen_mm, text: (c) => mm(c.rms_seen_mm, 3) },
    { key: 'evidence', label: 'evidence, nats', number: true, value: (c) => c.evidence_nats, text: (c) => (c.evidence_nats === null ? NONE : c.evidence_nats.toFixed(1)) },
    { key: 'usual', label: 'usual', value: (c) => c.usual, text: (c) => c.usual ?? '', class: 'name' },
    { key: 'source', label: 'source', value: (c) => c.source, text: (c) => c.source ?? '', class: 'reason' },
  ];
  return section('causes', title, 'Causes',
    likelihoods(data.causes, named),
    table({ caption: 'Causes', name: 'causes', columns, rows: data.causes, searchable: false }).element,
    data.zeros_alone && h('p', { class: 'notice', 'data-name': 'zeros', text: zeros(data) }),
    h('p', { class: 'notice', text: 'Seen: what is left of it where base and target, which are fitted, stand as well as they can beside it.' }),
    data.rivals?.length > 0 && [h('h3', { class: 'apart', text: 'What it is not, as far as these data tell' }), table({ caption: 'Rivals', name: 'rivals', columns: columns.filter(told(data.rivals)), rows: data.rivals }).element]);
}

/** More causes than this are in the table alone. */
const MOST_BARS = 12;

/** How likely each cause is: those that no other contests together, then each set of alternatives. */
function likelihoods(causes, named) {
  const places = [...new Set(causes.map((cause) => cause.slot))].map((slot) => causes.filter((cause) => cause.slot === slot));
  const alone = places.filter((place) => place.length === 1).flat();
  const open = places.filter((place) => place.length > 1);
  const group = (heading, rows) => [
    heading && h('h3', { class: 'apart', text: heading }),
    bars({ label: 'Probability', most: 1, rows: rows.slice(0, MOST_BARS).map((cause) => ({ label: short(cause), value: cause.posterior, text: percent(cause.posterior), colour: 'after' })) }),
    rows.length > MOST_BARS && h('p', { class: 'notice', text: `and ${rows.length - MOST_BARS} more in the table` }),
  ];
  const together = places.length > 1 ? (named ? 'Each is there, beside the others' : 'Each beside the others') : null;
  const oneOf = (count) => `One of ${count} that these data ${named ? 'cannot tell apart' : 'leave open'}`;
  return [alone.length > 0 && group(together, alone), ...open.map((rows) => group(oneOf(rows.length), rows))];
}

/** Whether a column says anything of one of the rows. */
const told = (rows) => (column) => rows.some((row) => (column.value(row) ?? null) !== null);

/** What the offsets of the joints would do alone: first of all, of an arm that was never calibrated. */
function zeros({ zeros_alone: alone, causes }) {
  const deg = (rad) => `${rad < 0 ? '−' : '+'}${Math.abs((180 / Math.PI) * rad).toFixed(3)} deg`;
  const apart = causes.some((cause) => cause.effect === 'joint_offset') ? '' : '; beside geometry as wide as this arm\'s they are not told from it';
  return `Joint offsets alone would take the gap from ${mm(alone.before_rms_mm, 3)} to ${mm(alone.after_rms_mm, 3)} mm: ${alone.joints.map((one) => `joint ${one.joint} ${deg(one.offset_rad)}`).join(', ')}${apart}.`;
}

const short = (cause) => causeName(cause).replace(' of joint ', ', J').replace('compliance', 'compl.').replace('eccentricity', 'ecc.').replace('second harmonic', '2nd harm.');

function falseSection(data) {
  const columns = [
    { key: 'line', label: 'line', number: true, value: (row) => row.line, text: (row) => String(row.line) },
    { key: 'id', label: 'id', value: (row) => row.id, text: (row) => row.id ?? '', class: 'name' },
    { key: 'off', label: 'off by, mm', number: true, value: (row) => row.off_mm, text: (row) => mm(row.off_mm, 3) },
    { key: 'like', label: 'looks like', value: (row) => row.looks_like, text: (row) => row.looks_like ?? '', class: 'reason' },
  ];
  return section('false', `${plural(data.false_rows.length, 'row')} set aside as false`, 'False rows', table({ caption: 'False rows', name: 'false', columns, rows: data.false_rows }).element);
}

function limitSection(data) {
  const of = (entry) => `${words(entry.effect)}${entry.joints.length ? ` of ${entry.joints.length > 1 ? 'joints' : 'joint'} ${entry.joints.join(', ')}` : ''}`;
  const columns = [
    { key: 'effect', label: 'effect', value: causeName, text: causeName, class: 'name' },
    { key: 'size', label: 'seen from', number: true, value: (one) => one.size, text: (one) => `${number(one.size)} ${one.unit}` },
  ];
  return section('limits', 'What these data cannot tell', 'Limits',
    data.untestable_detail.length > 0
      ? h('dl', { class: 'facts wide' }, data.untestable_detail.map((entry) => h('div', {}, h('dt', { text: of(entry) }), h('dd', { text: entry.reason }))))
      : h('p', { class: 'calm', text: 'Every effect of the library can be tested with them.' }),
    data.detectable.length > 0 && [h('h3', { class: 'apart', text: 'From which size on an effect would have been seen' }), table({ caption: 'Detectable sizes', name: 'detectable', columns, rows: data.detectable }).element]);
}
