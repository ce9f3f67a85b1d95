// The target that is chosen: where it stands in the source, its numbers at this minute.

import { deg, h, mm, number } from './dom.js';
import { length } from './course.js';
import { lineOf, sourceLine } from './source.js';

const vector = (v, decimals = 4) => v.map((value) => mm(value, decimals)).join(', ');

export function targetCard(scene) {
  const { course, correction, state, motions } = scene;
  const body = h('div', { class: 'card-body' });
  const card = h('div', { class: 'card', 'aria-live': 'polite', id: 'target' }, h('h3', { text: 'Target' }), body);
  const show = () => {
    const i = state.point;
    if (i === null) return body.replaceChildren(h('p', { class: 'calm', text: 'Click on a target, or choose one in the table of motions.' }));
    const motion = motions.get(course.points.motion[i]);
    const name = motion ? nameOf(motion, course.points.value[i]) : `target ${i + 1}`;
    card.querySelector('h3').textContent = `Target ${name}`;
    const now = course.at(state.t);
    const before = course.error(i, now);
    const after = course.error(i, correction.leftShares(state.t));
    const taken = course.error(i, correction.correctedShares(state.t)).map((value) => -value);
    const row = (label, text, note) => h('div', {}, h('dt', { text: label }), h('dd', { text }, note && h('span', { class: 'note', text: note })));
    const bucket = correction.bucketAt(state.t);
    const isCorrected = motion?.status === 'compensated';
    body.replaceChildren(
      h('dl', { class: 'numbers' },
        row('in the base', `${vector(course.position(i), 3)} mm`),
        row('joints', `${course.joints(i).map((q) => deg(q, 2)).join(', ')}°`),
        row('at', `${number(course.from + state.t)} ${course.unit}${bucket ? `, bucket ${bucket.index}` : ''}`),
        row('uncorrected', `${mm(length(before))} mm`, vector(before)),
        isCorrected && row('corrected', correction.inBuckets ? `${mm(length(after))} mm` : `≤ ${mm(motion.after_mm)} mm`, correction.inBuckets ? vector(after) : 'at any minute'),
        isCorrected && row('correction', `${mm(length(taken))} mm`, vector(taken)),
        motion && row('worst of all minutes', `${mm(motion.before_mm)} mm`, isCorrected ? `${mm(motion.after_mm)} mm corrected` : motion.status)),
      motion && h('p', { class: 'where' }, `${motion.file}:${motion.line}`, motion.routine && ` in ${motion.routine}`),
      motion && sourceLine(lineOf(scene, motion)));
    return undefined;
  };
  state.on('t point', show);
  show();
  return card;
}

/** A motion's target by its name, or by its line. */
export function nameOf(motion, value = 0) {
  const name = motion.target ?? `line ${motion.line}`;
  return value > 0 ? `${name} (value ${value + 1})` : name;
}
