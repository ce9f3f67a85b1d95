// The page of `driftpost compensate`.

import { NONE, count, h, mm, plural, store } from './dom.js';
import { Correction, Course } from './course.js';
import { armSection } from './compensation_arm.js';
import { curveSection } from './compensation_curves.js';
import { motionSection } from './compensation_motions.js';
import { sourceSection } from './source.js';
import { figure, figures, messages, record, section } from './layout.js';

const WARM_SHARE = 0.75;

export function compensation({ data, view, version }) {
  const refused = data.errors.length > 0;
  const course = view.course && view.points.motion.length > 0 ? new Course(view) : null;
  const correction = course && new Correction(course, data);
  const point = course && worstPoint(course);
  const scene = {
    data, view, course, correction,
    motions: new Map(data.motions.map((motion) => [motion.index, motion])),
    state: store({ t: course ? Math.round(course.end * WARM_SHARE) : 0, times: 20, point, corrected: false, joints: course?.joints(point) ?? null }),
  };
  const totals = view.totals ?? sums(data.motions);
  const sections = [
    () => overview(data, view, totals, refused),
    () => course && armSection(scene),
    () => course && !refused && curveSection(scene),
    () => data.motions.length > 0 && motionSection(scene),
    () => view.source && view.source.files.length > 0 && sourceSection(scene),
    () => record(provenance(view), version),
  ];
  const verdict = refused
    ? `Refused: nothing was written`
    : `${plural(totals.motions, 'motion')}: ${count(totals.compensated)} compensated, ${count(totals.kept)} kept`;
  return { kind: 'compensation', verdict, tone: refused ? 'bad' : totals.kept > 0 || data.warnings.length > 0 ? 'warn' : 'good', sections };
}

const sums = (motions) => {
  const of = (status) => motions.filter((motion) => motion.status === status).length;
  return { motions: motions.length, compensated: of('compensated'), kept: of('kept'), refused: of('refused') };
};

function overview(data, view, totals, refused) {
  const many = data.buckets.length;
  const said = [
    refused && [h('h3', { text: 'Refused' }), messages(data.errors, 'bad')],
    data.warnings.length > 0 && [h('h3', { text: plural(data.warnings.length, 'warning') }), messages(data.warnings, 'warn')],
    !refused && data.warnings.length === 0 && h('p', { class: 'calm', text: 'No refusals, no warnings.' }),
  ];
  const cheaper = (data.other_tolerances ?? []).map((one) => `${one.tolerance_mm} mm ${one.buckets}`).join(', ');
  return section('overview', 'Overview', 'Overview', said,
    data.worst_before_mm !== null && figures(
      // of no target at all the worst is no zero
      totals.compensated > 0 && [
        figure('Worst error, uncorrected', mm(data.worst_before_mm), 'mm', 'any corrected target, any minute', 'before'),
        figure('Worst error, corrected', mm(data.worst_after_mm, data.worst_after_mm < 0.0005 ? 6 : 4), 'mm', 'any corrected target, any minute', 'after'),
      ],
      figure('Motions', count(totals.motions), '', `${count(totals.compensated)} compensated, ${count(totals.kept)} kept, ${count(totals.refused)} refused`),
      many > 0
        ? figure('Buckets', count(many), '', cheaper && `at other tolerances: ${cheaper}`)
        : figure('Form', formOf(totals), '', 'scaled at run time, no buckets'),
      totals.compensated > 0 && many > 0 && figure('Largest step between buckets', mm(data.worst_switch_jump_mm), 'mm', 'of the TCP'),
      totals.compensated > 0 && figure('One work-object shift instead', mm(data.rigid_shift_worst_mm), 'mm', 'would be left at worst'),
    ),
    view.shown && h('p', { class: 'notice', text: `${count(totals.motions)} motions are too many for one page: it holds ${count(view.shown)} of them: up to 10,000 that are kept or refused, and those with the largest corrections. Figures above and sums of routines are over all.` }),
    view.from_json && h('p', { class: 'notice', text: 'Made from JSON alone: arm, curves and source are on the page that `compensate --report` writes.' }));
}

function formOf(totals) {
  const forms = Object.entries(totals.by_form ?? {}).filter(([, n]) => n > 0).map(([name]) => name);
  return forms.join(', ') || NONE;
}

const provenance = (view) => [...(view.provenance ?? []), ...(view.settings ?? [])];

/** The target with the largest error when all has settled; the first of equals. */
function worstPoint(course) {
  const shares = course.at(course.end);
  let [worst, most] = [null, -1];
  for (let i = 0; i < course.count; i += 1) {
    const size = Math.hypot(...course.error(i, shares));
    if (size > most) [worst, most] = [i, size];
  }
  return worst;
}
