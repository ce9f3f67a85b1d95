// Residuals in the workspace, before and after, and the poses to measure next on the arm.

import { h, mm, number } from './dom.js';
import { ArmModel } from './arm3d.js';
import { arm as armOf } from './kinematics.js';
import { TargetCloud } from './targets3d.js';
import { view3d } from './scene.js';
import { colour, onTheme } from './theme.js';
import { choice, slider } from './controls.js';
import { section } from './layout.js';
import { rowsOf } from './diagnosis_residuals.js';
import { table } from './table.js';

const MOST_TIMES = 2000;
const STEPS = 200;
const timesOf = (value) => Math.round(MOST_TIMES ** (value / STEPS));
const valueOf = (times) => Math.round((Math.log(times) / Math.log(MOST_TIMES)) * STEPS);

export function poseSection(scene) {
  const { data, view, state } = scene;
  const residuals = view.residuals;
  scene.rows ??= rowsOf(residuals);
  const view3 = view3d(`Residuals of ${residuals.line.length} rows in the workspace and the arm in 3-D. Arrow keys with Shift turn it, plus and minus zoom, Home looks from the start again.`);
  const next = nextTable(data, view, state);
  const note = h('p', { class: 'hud', role: 'status' });
  if (!view3) return section('workspace', 'In the workspace', 'Workspace', h('p', { class: 'notice', text: 'This browser draws no 3-D (WebGL is off).' }), next);
  const tool = data.tool_mm ?? [0, 0, 0];
  const model = new ArmModel(armOf(view.robot), { thickness: reach(view.robot) / 34, transparent: true, opacity: 0.55, axes: false });
  const cloud = new TargetCloud(residuals.p_mm);
  cloud.path.visible = false;
  view3.scene.add(model.group, cloud.group);
  view3.dressed(() => {
    model.paint(colour('arm'), colour('arm-joint'));
    cloud.paint({ path: colour('path'), ring: colour('accent') });
  });
  const sizes = scene.rows.filter((row) => !row.outlier).map((row) => row.before).sort((a, b) => a - b);
  const most = Math.max(sizes[Math.floor(sizes.length * 0.95)] ?? 0, 1e-6);
  state.times = Math.min(Math.max(Math.round((reach(view.robot) * 0.08) / most), 10), MOST_TIMES);
  const refresh = view3.beforePicture(() => {
    const flat = state.after ? residuals.after_mm : residuals.before_mm;
    cloud.show((i, e) => {
      // a false row would dwarf all others
      for (let k = 0; k < 3; k += 1) e[k] = residuals.outlier[i] ? 0 : flat[3 * i + k];
    }, state.times, most);
    cloud.mark(state.row);
    const pose = state.pose === null ? null : data.next_measurements[state.pose];
    const row = state.row === null ? null : scene.rows[state.row];
    const q = pose?.q_deg ?? row?.q ?? scene.rows[0]?.q ?? view.robot.joint.map(() => 0);
    const tcp = model.pose(q, tool).map((value) => value.toFixed(1)).join(', ');
    note.textContent = pose ? `to measure next: pose ${state.pose + 1}, point at ${tcp} mm` : row ? `line ${row.line}: ${mm(row.before, 3)} mm before, ${mm(row.after, 3)} mm after, drawn at ${tcp} mm` : '';
    note.hidden = note.textContent === '';
  });
  state.on('row after times pose', refresh);
  onTheme(refresh);
  state.on('row', () => { state.pose = null; });
  view3.onPick(() => cloud.dots, (i) => state.set({ row: i }));
  look(view3, residuals, reach(view.robot));
  refresh();
  view3.canvas.windowPlace = (i) => view3.toWindow(residuals.p_mm.slice(3 * i, 3 * i + 3));
  const panel = h('div', { class: 'panel' },
    choice({ label: 'Residuals', name: 'after', options: [['no', 'before'], ['yes', 'after']], value: 'no', on: (key) => state.set({ after: key === 'yes' }) }),
    slider({ label: 'Arrows enlarged', name: 'times', min: 0, max: STEPS, step: 1, value: valueOf(state.times), show: (value) => `${timesOf(value)} ×`, on: (value) => state.set({ times: timesOf(value) }) }).element,
    h('p', { class: 'calm', text: 'Base and target are fitted in both; “after” has causes and background geometry taken off.' }));
  return section('workspace', 'In the workspace', 'Workspace',
    h('div', { class: 'stage' }, h('div', { class: 'screen' }, view3.element, note,
      h('p', { class: 'scale' }, h('span', { text: '0' }), h('span', { class: 'ramp', 'aria-hidden': 'true' }), h('span', { text: `${mm(most, 3)} mm` }))), panel),
    next);
}

/** How far the arm reaches, about, mm. */
const reach = (robot) => [...robot.joint, robot.flange].reduce((sum, { origin_mm }) => sum + Math.hypot(...origin_mm), 0);

function look(view3, residuals, size) {
  const low = [-0.15 * size, -0.15 * size, 0];
  const high = [0.15 * size, 0.15 * size, 0.6 * size];
  residuals.p_mm.forEach((value, i) => { low[i % 3] = Math.min(low[i % 3], value); high[i % 3] = Math.max(high[i % 3], value); });
  view3.lookAt(low, high);
}

/** The poses to measure, where there is no arm to show them with. */
export const nextSection = ({ data, view, state }) => (data.next_measurements.length > 0 ? section('next', 'What to measure next', 'Next', nextTable(data, view, state)) : null);

function nextTable(data, view, state) {
  if (data.next_measurements.length === 0) return null;
  const rows = data.next_measurements.map((pose, i) => ({ ...pose, i }));
  const columns = [
    { key: 'i', label: 'pose', number: true, value: (row) => row.i, text: (row) => String(row.i + 1) },
    ...rows[0].q_deg.map((_, j) => ({ key: `q${j}`, label: `J${j + 1} ${view.robot?.joint[j].type === 'prismatic' ? 'mm' : 'deg'}`, number: true, value: (row) => row.q_deg[j], text: (row) => row.q_deg[j].toFixed(1) })),
    { key: 'kg', label: 'payload kg', number: true, value: (row) => row.payload_kg, text: (row) => number(row.payload_kg) },
    { key: 'dir', label: `approach J1 to J${rows[0].dir.length}`, value: (row) => row.dir.join(), text: (row) => row.dir.map((sign) => (sign < 0 ? '−' : '+')).join(' ') },
  ];
  const list = table({ caption: 'What to measure next', name: 'next', columns, rows, searchable: false, onRow: view.robot && ((row) => { list.choose(row); state.set({ pose: row.i }); }) });
  return h('div', {}, h('h3', { class: 'apart', text: `What to measure next, ${data.next_reason}` }), list.element);
}
