// Reports on a controller: what it is, and what its own kinematics say of a program.

import { NONE, count, mm, plural } from './dom.js';

const VERDICTS = {
  agrees: ['The controller\'s own kinematics agree', 'good'], differs: ['The controller\'s own kinematics do not agree', 'bad'], out_of_reach: ['Agrees where it was asked; targets are out of reach', 'bad'],
  nothing_asked: ['Nothing was asked', 'bad'], no_conclusion: ['No conclusion: the controller calculates another flange than it shows', 'warn'], not_offered: ['This controller does not calculate for others', 'warn'],
};
const quadrants = (value) => (value ? `${value.ours.join(', ')} here, ${value.controller.join(', ')} there` : null);

export function checked(data) {
  const targets = data.targets ?? [];
  const [wrong, worst] = [targets.filter((one) => !one.agrees), (key) => targets.reduce((most, one) => Math.max(most, one[key] ?? 0), 0)];
  const row = (one) => ({
    at: one.at, element: one.element, agrees: one.agrees, 'apart (mm)': one.apart_mm, 'apart (deg)': one.apart_deg, 'joints apart (deg)': one.joints_deg, reached: one.joints_deg !== null,
    'confdata that differ': quadrants(one.configurations), solutions: one.solutions?.count ?? null, 'ours among them': one.solutions?.ours ?? null,
  });
  const { controller = {} } = data;
  return {
    kind: 'targets put to a controller', verdict: VERDICTS[data.verdict] ?? [data.verdict, ''],
    shown: ['verdict', 'targets', 'out_of_reach', 'elements_out_of_reach', 'display_mm', 'not_known', 'robot', 'controller', 'host'],
    figures: [
      data.host && ['Controller', data.host, '', [controller.robot, controller.dialect].filter(Boolean).join(', ')],
      ['Targets asked for', count(targets.length), '', wrong.length > 0 ? `${count(wrong.length)} do not agree` : '', wrong.length > 0 ? 'before' : ''],
      targets.length > 0 && ['Worst', mm(worst('apart_mm')), 'mm', `${worst('apart_deg').toFixed(4)} deg, joints ${worst('joints_deg').toFixed(4)} deg`],
      ['Display and calculation', data.display_mm === undefined ? NONE : mm(data.display_mm), 'mm', 'apart'],
      data.out_of_reach && ['Out of reach', count(data.out_of_reach.length), '', `motions${data.elements_out_of_reach?.length > 0 ? `, and ${plural(data.elements_out_of_reach.length, 'element')} of others` : ''}, of ${data.robot}`],
      data.not_known !== undefined && ['Not asked for', count(data.not_known), '', 'motions whose targets only the running program knows'],
    ].filter(Boolean),
    lists: [
      { key: 'out_of_reach', title: 'Motions whose targets are out of reach', short: 'Out of reach', rows: (data.out_of_reach ?? []).map((at) => ({ motion: at })) },
      { key: 'elements_out_of_reach', title: 'Elements of scheduled targets that are out of reach', short: 'Elements', rows: (data.elements_out_of_reach ?? []).map((one) => ({ motion: one.at, element: one.element })) },
      { key: 'wrong', title: 'Targets at which it does not agree', short: 'Not agreeing', rows: wrong.map(row) },
      { key: 'targets', title: 'Every target that was asked for', short: 'Targets', rows: targets.map(row) },
    ],
  };
}

export function info(data) {
  const memory = (data.free_memory?.rapid ?? []).map((one) => ({ what: one.name, value: one.value, unit: one.unit }));
  const disks = (data.free_memory?.disks ?? []);
  return {
    kind: 'controller',
    verdict: [`${data.robot ?? 'unknown robot'}, ${data.dialect ?? ''}: ${data.mode}, motors ${data.motors}, RAPID ${data.execution}`, ''],
    shown: ['controller', 'virtual', 'system', 'robotware', 'dialect', 'robot', 'mode', 'motors', 'execution', 'absolute_accuracy', 'writer', 'free_memory', 'corrected', 'options', 'tasks'],
    figures: [
      ['Controller', data.controller ?? NONE, '', data.virtual ? 'virtual' : ''], ['System', data.system ?? NONE, '', `RobotWare ${data.robotware}`], ['Robot', data.robot ?? NONE],
      ['Mode', data.mode, '', `motors ${data.motors}, RAPID ${data.execution}`], ['Absolute Accuracy', data.absolute_accuracy === true ? 'ON' : data.absolute_accuracy === false ? 'off' : 'not known', '', '', data.absolute_accuracy ? 'before' : ''],
      ['Right to write', data.writer ? `held by ${typeof data.writer === 'object' ? Object.values(data.writer).filter(Boolean).join(', ') : data.writer}` : 'nobody holds it'],
    ],
    lists: [
      { key: 'corrected', title: 'Corrected programs', short: 'Corrected', rows: (data.corrected ?? []).map((one) => ({ task: one.task, module: one.module, ...one.values, 'it said': one.said })) },
      { key: 'tasks', title: 'Tasks', rows: (data.tasks ?? []).map((one) => ({ task: one.name, state: one.state, 'moves an arm': one.moves, active: one.active, modules: one.modules.map((module) => module.name).join(', ') || 'no module' })) },
      { key: 'memory', title: 'Memory of RAPID', short: 'Memory', rows: memory },
      { key: 'disks', title: 'Free on disk', short: 'Disks', rows: disks },
      { key: 'options', title: 'Options', rows: (data.options ?? []).map((option) => ({ option })) },
    ],
  };
}
