// The page of `driftpost simulate`.

import { count, h, mm, number, plural } from './dom.js';
import { curves } from './curves.js';
import { figure, figures, nameOfFile, notes, printed, record, section } from './layout.js';
import { lists, ordered } from './parts.js';
import { listOf } from './plain.js';

const shortFile = (row) => ({ ...row, file: row.file ? nameOfFile(row.file) : row.file });

/** Passes along the axis that they have: minutes since the beginning in a scenario, else warm-up minutes; a robot that stands leaves a gap. */
function axisOf(passes, marks) {
  const t = passes.map((pass) => pass.t_min);
  const isScenario = marks.length > 0 || t.some((value, i) => i > 0 && value < t[i - 1]);
  if (!isScenario) return { x: t, label: 'warm-up minute', values: (of) => passes.map(of) };
  const stops = marks.filter((mark) => mark.standing && mark.to_min > mark.from_min).map((mark) => ({ at: (mark.from_min + mark.to_min) / 2, pass: null }));
  const ends = [0, Math.max(...passes.map((pass) => pass.at_min), ...marks.map((mark) => mark.to_min))].map((at) => ({ at, pass: null }));
  const all = [...ends, ...passes.map((pass) => ({ at: pass.at_min, pass })), ...stops].sort((a, b) => a.at - b.at);
  return { x: all.map((one) => one.at), label: 'minutes since the beginning', values: (of) => all.map((one) => (one.pass ? of(one.pass) : null)) };
}

/** Marks of the curves: those of one moment share their words. */
function marksOf(marks) {
  const at = new Map();
  for (const mark of marks) at.set(mark.from_min, [...(at.get(mark.from_min) ?? []), mark]);
  return [...at].map(([from, all]) => {
    const stands = all.find((mark) => mark.standing);
    return { at: from, label: all.map((mark) => mark.words).join(', '), colour: 'bucket', dash: [3, 3], to: stands?.to_min, shade: stands && 'shade' };
  });
}

function overTime(passes, marks) {
  const { x, label, values } = axisOf(passes, marks);
  const dots = passes.length === 1;
  const shown = marksOf(marks);
  const worst = Math.max(...passes.map((pass) => pass.after.max_mm ?? 0));
  const common = { x, xLabel: label, height: 300, marks: () => shown };
  const words = shown.map((mark) => `${mark.label} at minute ${number(mark.at)}`).join(', ');
  const series = (name, colour, of) => ({ label: name, colour, dots, gaps: true, values: values(of) });
  return [
    curves({
      ...common, title: 'Worst error of the TCP', yLabel: 'mm', text: `Worst error as executed ${mm(worst)} mm. ${words}`,
      series: [
        series('original', 'before', (pass) => pass.before.max_mm), series('as executed', 'after', (pass) => pass.after.max_mm),
        series('path between targets, as executed', 'claim', (pass) => pass.path_after_mm),
      ],
    }).element,
    marks.length > 0 && curves({
      ...common, title: 'How warm the robot is', yLabel: 'warm-up minute', text: `Warm-up minute of the robot and of the program's clock. ${words}`,
      series: [series('the robot', 'before', (pass) => pass.t_min), series('by the program\'s clock', 'after', (pass) => pass.program_min)],
    }).element,
  ].filter(Boolean);
}

export function simulation({ data, view, version }) {
  const passes = data.minutes;
  const worst = data.worst;
  const t = passes.map((pass) => pass.t_min);
  const max = (of) => passes.reduce((most, pass) => Math.max(most, of(pass) ?? 0), 0);
  const one = passes.length === 1;
  const marks = data.marks ?? [];
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
      notes(data.notes), printed(view)),
    passes.length > 0 && section('curves', 'Errors at each minute', 'Curves',
      h('div', { class: 'plots' }, overTime(passes, marks)),
      marks.length > 0 && listOf('steps', marks.map((mark) => ({ step: mark.words, 'from (min)': mark.from_min, 'to (min)': mark.to_min, 'the robot stands': mark.standing }))),
      listOf('passes', rows)),
    ...lists({ ...data, switches: data.switches.map((one_) => ordered(one_, ['t_min', 'jump_mm'])), functions: data.functions.map((one_) => ordered(one_, ['name', 'calls', 'statements', 'arithmetic', 'trigonometric'])), messages: data.messages.map(shortFile), unchanged: data.unchanged.map(shortFile) }, { switches: 'Switches', unchanged: 'Motions not corrected', messages: 'Messages', unknown_instructions: 'Unknown instructions', functions: 'Functions' }),
    record(view.provenance ?? [], version),
  ].map((one) => () => one);
  return { kind: 'simulation', verdict: `${plural(data.executed.motions, 'motion')} executed: ${mm(max((pass) => pass.after.max_mm))} mm at worst`, tone: failed || data.executed.motions === 0 ? 'bad' : 'good', sections };
}

