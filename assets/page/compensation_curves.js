// Curves of a compensation: errors over the warm-up, the drift's share, corrections and joints along the program.

import { h, mm } from './dom.js';
import { length, worstCurves } from './course.js';
import { curves } from './curves.js';
import { section } from './layout.js';
import { nameOf } from './target_card.js';

const SAMPLES = 240;
/** Of more targets than this every second, third ... is drawn. */
const DRAWN = 4000;

export function curveSection(scene) {
  return section('curves', 'Errors and corrections', 'Curves',
    h('div', { class: 'plots' }, overTime(scene), shareOverTime(scene), alongProgram(scene), jointsAlong(scene)));
}

function minutesOf({ course, correction }) {
  const even = Array.from({ length: SAMPLES + 1 }, (_, i) => (course.end * i) / SAMPLES);
  // just before and at each change of buckets, so that steps are steep
  const steps = correction.buckets.slice(1).flatMap((bucket) => [bucket.from_min - 1e-6, bucket.from_min]);
  return [...new Set([...even, ...steps.filter((t) => t < course.end)])].sort((a, b) => a - b);
}

const timeLabel = (course) => (course.byTemperature ? 'degrees Celsius' : 'warm-up minute');

function overTime(scene) {
  const { course, correction, data, view, state } = scene;
  const minutes = minutesOf(scene);
  const worst = worstCurves(course, correction, minutes);
  const after = worst.after ?? minutes.map(() => data.worst_after_mm);
  const claims = view.claims?.points ?? [];
  const claimed = minutes.map((t) => null);
  for (const [t, value] of claims) {
    const near = minutes.reduce((best, at, i) => (Math.abs(at - t) < Math.abs(minutes[best] - t) ? i : best), 0);
    claimed[near] = value;
  }
  const series = () => {
    const i = state.point;
    const own = i === null ? [] : [
      { label: 'chosen target', colour: 'before', dash: [5, 4], width: 1.5, values: minutes.map((t) => length(course.error(i, course.at(t)))) },
      correction.inBuckets && { label: 'chosen target, corrected', colour: 'after', dash: [5, 4], width: 1.5, values: minutes.map((t) => length(course.error(i, correction.leftShares(t)))) },
    ].filter(Boolean);
    return [
      { label: 'worst target, uncorrected', colour: 'before', values: worst.before },
      { label: worst.after ? 'worst target, corrected' : 'corrected, at worst over all minutes', colour: 'after', values: after },
      ...own,
      ...(claims.length > 0 ? [{ label: view.claims.text, colour: 'claim', dots: true, size: 8, values: claimed }] : []),
    ];
  };
  const plot = curves({
    title: 'Error of the TCP over the warm-up', x: minutes.map((t) => t + course.from), xLabel: timeLabel(course), yLabel: 'mm',
    text: `Worst error uncorrected up to ${mm(data.worst_before_mm)} mm, corrected up to ${mm(data.worst_after_mm)} mm`,
    series: series(), needle: () => state.t + course.from,
    onClick: (t) => state.set({ t: Math.round(t - course.from) }), height: 280,
  });
  state.on('t', plot.follow);
  state.on('point', () => plot.show(series()));
  return plot.element;
}

function shareOverTime({ course, correction, state, data }) {
  const minutes = course.t;
  const total = course.count > 0 ? state.point ?? 0 : 0;
  const settled = length(course.error(total, course.at(course.end))) || 1;
  const values = course.nodes === 1 ? course.shares[0] : minutes.map((t) => length(course.error(total, course.at(t))) / settled);
  const borders = correction.buckets.slice(1).map((bucket) => bucket.from_min + course.from);
  const plot = curves({
    title: correction.inBuckets ? `Share of the drift, and the ${correction.buckets.length} buckets` : 'Share of the drift', x: minutes.map((t) => t + course.from),
    xLabel: timeLabel(course), yLabel: 'share', text: `The share of the settled drift over the warm-up${correction.inBuckets ? ` and the borders of ${correction.buckets.length} buckets` : ''}`,
    series: [{ label: 'share that has come', colour: 'text', values }, ...(borders.length ? [{ label: 'border of two buckets', colour: 'bucket', values: minutes.map(() => null), dash: [3, 3] }] : [])],
    marks: () => borders.map((at) => ({ at, colour: 'bucket', dash: [3, 3] })), needle: () => state.t + course.from,
    onClick: (t) => state.set({ t: Math.round(t - course.from) }), height: 280,
  });
  state.on('t', plot.follow);
  return plot.element;
}

/** Indices of the targets that are drawn. */
function drawn(course) {
  const step = Math.max(Math.ceil(course.count / DRAWN), 1);
  return Array.from({ length: Math.ceil(course.count / step) }, (_, i) => i * step);
}

function alongProgram({ course, motions, state, data }) {
  const which = drawn(course);
  const of = (i) => motions.get(course.points.motion[i]);
  const few = which.length <= 400;
  const plot = curves({
    title: 'Correction of each target, in the order of the program', x: which.map((i) => i + 1), xLabel: 'target', whole: true, yLabel: 'mm',
    text: `Corrections of ${which.length} targets`,
    series: [
      { label: 'largest correction', colour: 'before', dots: few, values: which.map((i) => of(i)?.max_correction_mm ?? null) },
      { label: 'error left at worst', colour: 'after', dots: few, values: which.map((i) => of(i)?.after_mm ?? null) },
      { label: 'path, off between targets', colour: 'claim', dots: few, values: which.map((i) => of(i)?.mid_path_mm ?? null) },
    ],
    needle: () => (state.point === null ? null : state.point + 1),
    onClick: (_, at) => state.set({ point: which[at] }),
  });
  state.on('point', plot.follow);
  return plot.element;
}

function jointsAlong({ course, state, motions }) {
  const which = drawn(course);
  const plot = curves({
    title: 'Joints at the targets', x: which.map((i) => i + 1), xLabel: 'target', whole: true, yLabel: 'deg', zero: false,
    text: `Nominal joints at ${which.length} targets`,
    series: [1, 2, 3, 4, 5, 6].map((j) => ({ label: `J${j}`, colour: `joint-${j}`, width: 1.5, dots: which.length === 1, values: which.map((i) => course.points.q_deg[6 * i + j - 1]) })),
    needle: () => (state.point === null ? null : state.point + 1),
    onClick: (_, at) => state.set({ point: which[at] }),
  });
  state.on('point', plot.follow);
  return plot.element;
}
