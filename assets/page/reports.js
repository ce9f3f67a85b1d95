// What each report without pictures is made of: its verdict, its figures, its lists with their headings and units.
//
// What a description does not name (`shown`) stands on the page by its keys: nothing of a result is left out.

import { NONE, count, mm, number, plural } from './dom.js';
import { checked, info } from './reports_link.js';
import { compared, golden, inspected, restored } from './reports_program.js';
import { planned } from './reports_plan.js';

const sizes = (one) => ({ 'rms (mm)': one.rms_mm, 'mean (mm)': one.mean_mm, 'max (mm)': one.max_mm });

function state(data) {
  const held = data.amount_held ? `, held at the ${data.amount_held}` : '';
  const sigma = (value) => `± ${number(Number(value?.toPrecision(2)))}`;
  const cools = data.tau_cool_min !== null;
  const every = [...new Set(data.plan.flatMap((point) => point.intervals.map((one) => one.every_min)))];
  const touch = (one) => ({ line: one.line, minute: one.t_min, point: one.point, 'seen, share': one.seen, 'off, sigmas': one.off_sigmas, 'known, share': one.share, 'known, ±': one.sigma, 'smoothed, share': one.smoothed, 'smoothed, ±': one.smoothed_sigma, outcome: one.outcome });
  const left = (point, min) => point.intervals.find((one) => one.every_min === min)?.rms_mm ?? null;
  return {
    kind: 'thermal state',
    verdict: data.drifts_otherwise
      ? ['This arm does not drift as the table says', 'bad']
      : [`Drifts ${data.amount.toFixed(2)} ± ${data.amount_sigma.toFixed(2)} times as far as the table, τ ${data.tau_min.toFixed(0)} min`, data.refused > 0 || data.amount_held ? 'warn' : 'good'],
    shown: ['amount', 'amount_sigma', 'amount_held', 'drifts_otherwise', 'growth', 'refused', 'tau_min', 'tau_sigma_min', 'tau_cool_min', 'tau_cool_sigma_min', 'stops', 'touches', 'plan', 'false_first'],
    figures: [
      ['Amount of drift', data.amount.toFixed(2), '', `± ${data.amount_sigma.toFixed(2)}, of the table's settled drift${held}`, 'after'],
      ['τ', data.tau_min.toFixed(0), 'min', sigma(data.tau_sigma_min)],
      ['τ of cooling', cools ? data.tau_cool_min.toFixed(0) : NONE, 'min', cools ? sigma(data.tau_cool_sigma_min) : 'no stop was seen'],
      ['Touches', count(data.touches.length), '', `${count(data.refused)} refused`],
      ['Growth of the table', data.growth],
    ],
    lists: [
      { key: 'false_first', title: 'First touches that are left out', short: 'Left out', rows: data.false_first.map((one) => ({ line: one.line, point: one.point, 'off (mm)': one.off_mm, 'sigma along the drift (mm)': one.sigma_mm })) },
      { key: 'refused', title: 'Touches that were refused', short: 'Refused', rows: data.touches.filter((one) => !one.taken).map(touch) },
      { key: 'stops', title: 'When the robot stood', short: 'Stops', rows: data.stops.map(([from, to]) => ({ 'from (min)': from, 'to (min)': to })) },
      {
        key: 'plan', title: 'How often to touch', short: 'Plan', notice: 'Left: what is left over a shift where the points drift most, one standard deviation, by the minutes between touches of that point.',
        rows: data.plan.map((point) => ({ point: point.point, 'moves (mm)': point.settled_mm, ...Object.fromEntries(every.map((min) => [`left, every ${number(min)} min (mm)`, left(point, min)])) })),
      },
      {
        key: 'touches', title: 'Every touch', short: 'Touches', notice: 'Shares of the settled drift: seen by this touch alone, known from all touches so far, and smoothed by all of them; each with one standard deviation.',
        rows: data.touches.map(touch),
      },
    ],
  };
}

function validated(data) {
  const rows = [['all', data], ['inside', data.inside], ['outside', data.outside]].filter(([, part]) => part?.n > 0);
  const against = (data.notes ?? []).find((text) => /^(NOT|WORSE)/.test(text));
  return {
    kind: 'model put to measurements it has not seen',
    verdict: against ? [against, 'bad'] : [`${mm(data.rms_mm)} mm rms with the model, ${mm(data.nominal.rms_mm)} without`, data.rms_mm < data.nominal.rms_mm ? 'good' : 'bad'],
    shown: ['n', 'rms_mm', 'mean_mm', 'max_mm', 'nominal', 'inside', 'outside', 'joints_outside', 'stops', 'worst'],
    figures: [
      ['With the model', mm(data.rms_mm), 'mm', `rms; ${mm(data.max_mm)} at worst`, 'after'], ['Nominal robot', mm(data.nominal.rms_mm), 'mm', `rms; ${mm(data.nominal.max_mm)} at worst`, 'before'],
      ['Poses', count(data.n), '', data.outside?.n > 0 ? `${count(data.outside.n)} outside of what the model was found in` : 'all inside of what the model was found in'],
    ],
    lists: [
      { key: 'parts', title: 'Inside and outside of the ranges that the model was found in', short: 'Ranges', rows: rows.map(([name, part]) => ({ poses: name, n: part.n, ...Object.fromEntries([['model', part], ['nominal', part.nominal]].flatMap(([of, one]) => Object.entries(sizes(one)).map(([key, value]) => [`${of} ${key}`, value]))) })) },
      { key: 'joints_outside', title: 'Joints that leave these ranges', short: 'Joints', rows: data.joints_outside.map(([joint, n]) => ({ joint, poses: n })) },
      { key: 'stops', title: 'When the robot stood', short: 'Stops', rows: data.stops.map(([from, to]) => ({ 'from (min)': from, 'to (min)': to })) },
      { key: 'worst', title: 'Rows with most left', short: 'Worst', rows: data.worst.map((one) => ({ line: one.line, 'left (mm)': one.mm })) },
    ],
  };
}

function tabulated(data) {
  const last = data.minutes.at(-1);
  return {
    kind: 'joints of targets over the warm-up', verdict: data.notes?.[1] ? [data.notes[1], ''] : null, shown: ['rows', 'minutes', 'targets'],
    figures: [['Targets', count(data.targets.length)], ['Minutes', count(data.minutes.length), '', last && `to ${number(last.t_min)}`], ['Rows of the table', count(data.rows)]],
    lists: [
      { key: 'minutes', title: 'How far targets are missed, minute by minute', short: 'Minutes', rows: data.minutes.map((one) => ({ minute: one.t_min, 'before, max (mm)': one.before.max_mm, 'before, rms (mm)': one.before.rms_mm, 'before, max (deg)': one.before.max_deg, 'after, max (mm)': one.after.max_mm, 'after, rms (mm)': one.after.rms_mm, 'after, max (deg)': one.after.max_deg })) },
      { key: 'targets', title: 'Targets', rows: data.targets.map((one) => ({ target: one.target, line: one.line, 'joints (deg)': one.q_deg, confdata: one.confdata })) },
    ],
  };
}

function examined(data) {
  const asked = data.measures.filter((one) => one.value !== null);
  const short = asked.filter((one) => one.judgement === 'falls short');
  return {
    kind: 'exam',
    verdict: asked.some((one) => one.judgement) ? [short.length > 0 ? `Falls short in ${short.length} of ${plural(asked.length, 'measure')}` : `Passes all ${plural(asked.length, 'measure')} that were asked`, short.length > 0 ? 'bad' : 'good'] : null,
    shown: ['measures'],
    figures: [['Sets', count(data.sets.length)], ['Measures asked', count(asked.length), '', `of ${count(data.measures.length)}`]],
    lists: [{ key: 'measures', title: 'Measures', rows: data.measures.map((one) => ({ measure: one.name, value: one.value, 'between, nine times in ten': one.ci90, sets: one.sets, 'passes at': one.pass, 'world-class at': one.world_class, 'small is good': one.small_is_good, judged: one.judgement })) }],
  };
}

const made = (data) => ({ kind: 'measurement sets of a virtual robot', verdict: [`${plural(data.sets, 'set')} in ${data.out_dir}`, ''], shown: [], figures: [], lists: [] });

export const REPORTS = {
  state, plan: planned, validate: validated, tabulate: tabulated, exam: examined, synth: made,
  diff: compared, inspect: inspected, golden, restore: restored, 'link check': checked, 'link info': info,
};
