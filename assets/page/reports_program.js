// Reports on programs: compared, listed, restored, held against a folder of cases.

import { NONE, count, mm, number, plural } from './dom.js';
import { nameOfFile } from './layout.js';

const margin = (one) => (one.wrist_margin_deg === null ? null : Math.min(one.wrist_margin_deg, one.elbow_margin_deg));
const numbers = (values, decimals) => values.map((value) => (value === null ? '9E9' : value.toFixed(decimals))).join(', ');

/** What a row of a comparison has beside its figures, in words. */
function remarks(motion, change) {
  return [
    !motion.same_frames && 'another instruction, tool or work object',
    motion.buckets.length === 0 && (motion.asked ? 'asks the model for another target' : motion.settled_mm !== null ? 'by the model at run time' : 'only known at run time'),
    change?.same_configuration === false && 'other confdata or external axes',
    change && change.joint === null && 'out of the arm\'s reach',
    change?.same_branch === false && 'another branch',
  ].filter(Boolean).join(', ');
}

function changeRow(motion, change, several) {
  return {
    ...(several ? { file: nameOfFile(motion.file) } : {}), line: motion.line, 'line after': motion.line_after, routine: motion.routine, move: motion.kind, target: motion.target,
    bucket: change?.index ?? null, 'moved (mm)': change?.dp_mm ?? motion.settled_mm, 'turned (deg)': change?.angle_deg ?? motion.settled_deg, joint: change?.joint ?? null, 'joint by (deg)': change?.joint_deg ?? null,
    'to a limit (deg)': change?.limit_margin_deg ?? null, 'to a singularity (deg)': change ? margin(change) : null, note: remarks(motion, change),
  };
}

/** Where a target lies, by its position or by its joints. */
const place = (target) => (target?.position_mm ? numbers(target.position_mm, 3) : target?.joints_deg ? numbers(target.joints_deg, 3) : '');

export function compared(data) {
  const worst = (motion) => motion.buckets.reduce((most, one) => (!most || one.dp_mm > most.dp_mm || (one.dp_mm === most.dp_mm && one.angle_deg > most.angle_deg) ? one : most), motion.asked);
  const several = new Set(data.motions.map((one) => one.file)).size > 1;
  const only = (one) => ({ file: one.file, line: one.line, move: one.kind });
  const { worst: most } = data;
  const verdict = data.same ? ['The same, byte for byte', 'good'] : !data.same_elsewhere ? ['Different beside the targets of motions', 'bad'] : ['Every token that is not the target of a motion is the same in both', 'good'];
  return {
    kind: 'comparison of two programs', verdict,
    shown: ['same', 'same_elsewhere', 'worst', 'motions', 'elsewhere', 'held_modes', 'only_before', 'only_after'],
    figures: [
      ['Largest change of a TCP', mm(most.dp_mm), 'mm', '', 'after'], ['Largest turn of a TCP', most.angle_deg === null ? NONE : most.angle_deg.toFixed(5), 'deg'], ['Largest change of a joint', most.joint_deg === null ? NONE : most.joint_deg.toFixed(5), 'deg'],
      ['Largest step between buckets', mm(most.bucket_step_mm), 'mm'], ['Nearest to a joint\'s limit', number(most.limit_margin_deg), 'deg'], ['Nearest to a singularity', number(most.singular_margin_deg), 'deg', 'wrist or elbow'],
      ['Configuration and branch', most.same_configuration ? 'the same' : 'NOT the same', '', most.same_configuration ? 'everywhere' : 'see the notes of the rows'],
    ],
    lists: [
      { key: 'elsewhere', title: 'What differs beside the targets', short: 'Elsewhere', rows: [...data.elsewhere, ...data.held_modes].map((text) => ({ difference: text })) },
      { key: 'only_before', title: 'Motions of the first program alone', short: 'Only before', rows: data.only_before.map(only) },
      { key: 'only_after', title: 'Motions of the second program alone', short: 'Only after', rows: data.only_after.map(only) },
      {
        key: 'motions', title: 'Motion by motion, each with its worst bucket', short: 'Motions', rows: data.motions.map((motion) => changeRow(motion, worst(motion), several)),
        folded: [{ key: 'buckets', title: 'Every bucket', rows: data.motions.filter((motion) => motion.buckets.length > 1).flatMap((motion) => motion.buckets.map((one) => changeRow(motion, one, several))) }],
      },
    ],
  };
}

export function inspected(data) {
  const kept = data.motions.filter((one) => !one.can).length;
  const several = new Set(data.motions.map((one) => one.file)).size > 1;
  const last = (motion) => motion.targets.findLast((one) => one.position_mm || one.joints_deg);
  const entries = data.entries_of ?? data.entries.map((name) => ({ name }));
  return {
    kind: 'what a program holds', verdict: data.notes?.[0] ? [data.notes[0], kept > 0 ? 'warn' : 'good'] : null,
    shown: ['modules', 'entries', 'entries_of', 'motions', 'form', 'form_because'],
    figures: [['Motions', count(data.motions.length), '', plural(data.modules.length, 'module')], ['Can be compensated', count(data.motions.length - kept), '', 'as far as the text tells', 'after'], ['Stay as they are', count(kept), '', '', kept > 0 ? 'before' : ''], ['Form', data.form, '', data.form_because]],
    lists: [
      {
        key: 'motions', title: 'Motions', rows: data.motions.map((one) => ({
          ...(several ? { file: nameOfFile(one.file) } : {}), line: one.line, routine: one.routine, move: one.kind, target: one.targets.map((target) => target.name ?? (target.position_mm || target.joints_deg ? '[...]' : 'expression')).join(' '), tool: one.tool, 'work object': one.wobj,
          'x, y, z mm or joints deg': place(last(one)), 'kept because': one.reason ? `${one.reason} (${one.code})` : null,
        })),
      },
      { key: 'modules', title: 'Modules', rows: data.modules.map((one) => ({ module: one.name, file: one.file, 'already compensated': one.compensated })) },
      { key: 'entries', title: 'Routines that nobody calls', short: 'Entries', rows: entries.map((one) => ({ routine: one.name, module: one.module ?? null })) },
    ],
  };
}

export function golden(data) {
  const different = data.cases.filter((one) => !one.same).length;
  const verdict = different === 0 ? [`${plural(data.cases.length, 'case')}, all as expected`, 'good'] : [`${count(different)} of ${plural(data.cases.length, 'case')} differ${data.updated ? ': what is expected was updated' : ''}`, data.updated ? 'warn' : 'bad'];
  return {
    kind: 'cases against what is expected of them', verdict, shown: ['cases', 'updated'], figures: [['Cases', count(data.cases.length)], ['Different', count(different), '', data.updated ? 'updated' : ''], ['As expected', count(data.cases.length - different)]],
    lists: [{ key: 'cases', title: 'Cases', rows: data.cases.map((one) => ({ case: one.case, 'as expected': one.same, 'files that differ': one.different_files?.join(', ') ?? null })) }],
  };
}

export function restored(data) {
  const wrong = data.files.filter((one) => !one.exact);
  return { kind: 'restored originals', verdict: wrong.length === 0 ? [`${plural(data.files.length, 'file')}, byte for byte the original`, 'good'] : [`${count(wrong.length)} of ${plural(data.files.length, 'file')} not byte for byte the original`, 'warn'], shown: [], figures: [], lists: [] };
}
