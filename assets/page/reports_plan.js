// The report of `driftpost plan`: what the chosen poses will tell, and the poses.

import { count, number, plural } from './dom.js';

/** Lines of a gear that are named in a row; all of them are in the folded table. */
const NAMED = 6;
const joints = (one) => (one.joint === null || one.joint === undefined ? '' : one.joint_b ? `${one.joint} to ${one.joint_b}` : String(one.joint));
const named = (one) => `${one.effect.replaceAll('_', ' ')} ${joints(one)}`.trim();
const from = (one) => `${number(one.seen_from)}${joints(one) && ` (${joints(one)})`}`;

/** One row for each effect: its joints from the best told to the worst. */
function effects(parameters) {
  return [...new Set(parameters.map((one) => one.effect))].map((effect) => {
    const own = parameters.filter((one) => one.effect === effect).sort((a, b) => a.seen_from / a.usual - b.seen_from / b.usual);
    const [best, worst] = [own[0], own.at(-1)];
    return {
      effect: effect.replaceAll('_', ' '), of: own.length, usual: best.usual, unit: best.unit, 'named from, best (joint)': from(best), 'named from, worst (joint)': own.length > 1 ? from(worst) : '',
      'not at its usual size: joints': own.filter((one) => one.seen_from > one.usual).map((one) => joints(one) || 'all').join(', '),
    };
  });
}

const pairsOf = (gear) => gear.confounded.map(([n, other]) => `${n} for ${other}`);
const gearRow = (gear) => ({
  joint: gear.joint, 'sigma (rad)': gear.sigma, 'named from (rad)': gear.seen_from, 'usual (rad)': gear.usual, 'told from all others': `${gear.told_apart} of ${gear.of}`,
  'most easily taken for another': gear.confounded.length > NAMED ? `${pairsOf(gear).slice(0, NAMED).join(', ')} and ${gear.confounded.length - NAMED} more below` : pairsOf(gear).join(', '),
});

const step = (one) => ({
  id: one.id, pose: one.pose_id ?? null, nest: one.nest ?? null, 'joints (deg)': one.q_deg?.map((q) => q.toFixed(3)).join(', ') ?? null,
  'approach, joint by joint': one.dir?.map((way) => (way > 0 ? '+' : way < 0 ? '−' : '0')).join(' ') ?? null, 'payload (kg)': one.payload_kg ?? null,
});

export function planned(data) {
  const open = data.confounded.filter((pair) => !pair.contained);
  const poses = data.steps.filter((one) => one.pose_id !== undefined);
  const pair = (one) => ({ 'true one': named(one.a), 'taken for': named(one.b), 'of its signal (%)': Number((100 * one.r2).toFixed(1)), separation: one.separation });
  return {
    kind: 'measurement plan',
    verdict: [`${plural(poses.length, 'measurement')} of ${plural(new Set(poses.map((one) => one.pose_id)).size, 'pose')}${poses.length < data.steps.length ? `, ${count(data.steps.length - poses.length)} of nests` : ''}`, ''],
    shown: ['steps', 'parameters', 'confounded', 'hidden', 'lines', 'exchanges'],
    figures: [
      ['Measurements', count(poses.length), '', plural(new Set(poses.map((one) => one.pose_id)).size, 'pose')], ['Of nests', count(data.steps.length - poses.length)],
      ['Never seen', count(data.hidden.length), '', 'effects at their usual size'], ['Stay confounded', count(open.length), '', 'pairs of effects at usual size'], ['Exchanges', count(data.exchanges)],
    ],
    lists: [
      {
        key: 'expected', title: 'Expected, each effect being the only cause beside the arm\'s tolerances', short: 'Expected', rows: effects(data.parameters), notice: 'Usual: of the joint that is told best.',
        folded: [{ key: 'parameters', title: 'Every joint', rows: data.parameters.map((one) => ({ effect: one.effect.replaceAll('_', ' '), joint: joints(one), usual: one.usual, 'named from': one.seen_from, sigma: one.sigma, unit: one.unit, 'told at its usual size': one.seen_from <= one.usual })) }],
      },
      {
        key: 'lines', title: 'Lines of the gears', short: 'Gears', rows: data.lines.map(gearRow),
        folded: [{ key: 'lines-confounded', title: 'Lines that are taken for another', rows: data.lines.flatMap((gear) => gear.confounded.map(([n, other]) => ({ joint: gear.joint, 'line, a turn': n, 'taken for': other }))) }],
      },
      { key: 'hidden', title: 'Never seen at their usual size, inside base, target and the arm\'s tolerances', short: 'Never seen', rows: data.hidden.map((one) => ({ effect: one.effect.replaceAll('_', ' '), joint: joints(one) })) },
      {
        key: 'confounded', title: 'Pairs that stay confounded at usual size', short: 'Confounded', rows: open.map(pair),
        folded: [{ key: 'contained', title: 'Pairs beside, where the second has more parameters and contains the first: the simpler is named', rows: data.confounded.filter((one) => one.contained).map(pair) }],
      },
      { key: 'steps', title: 'What to measure, in this order', short: 'Steps', rows: data.steps.map(step) },
    ],
  };
}
