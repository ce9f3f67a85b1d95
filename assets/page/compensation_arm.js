// The arm in 3-D: nominal and deformed, targets with their errors, minute and enlargement by sliders, joints to jog.

import { deg, h, mm, number } from './dom.js';
import { arm as armOf } from './kinematics.js';
import { ArmModel } from './arm3d.js';
import { TargetCloud } from './targets3d.js';
import { view3d } from './scene.js';
import { colour, onTheme } from './theme.js';
import { button, check, choice, slider } from './controls.js';
import { section } from './layout.js';
import { targetCard } from './target_card.js';

const PLAY_S = 16;
const MOST_TIMES = 500;
const STEPS = 200;
const MUCH = 4000;

const timesOf = (value) => Math.round(MOST_TIMES ** (value / STEPS));
const valueOf = (times) => Math.round((Math.log(times) / Math.log(MOST_TIMES)) * STEPS);

export function armSection(scene) {
  const { course, state, view } = scene;
  const arm = armOf(view.robot);
  const title = `${view.robot.name}: the arm, its drift enlarged`;
  const view3 = view3d(`The arm in 3-D with ${course.count} targets. Arrow keys with Shift turn it, plus and minus zoom, Home looks from the start again.`, course.count > MUCH);
  const card = targetCard(scene);
  const panel = h('div', { class: 'panel' }, timeControl(scene), enlargement(scene), shows(scene), jog(scene, arm));
  if (!view3) {
    return section('arm', title, 'Arm', h('p', { class: 'notice', text: 'This browser draws no 3-D (WebGL is off).' }), h('div', { class: 'stage' }, panel), card);
  }
  const nominal = new ArmModel(arm, { thickness: 30, transparent: true, opacity: 0.32, axes: false });
  const deformed = new ArmModel(arm, { thickness: 24, transparent: false, opacity: 1, axes: true });
  const cloud = new TargetCloud(course.points.p_mm);
  view3.scene.add(nominal.group, deformed.group, cloud.group);
  view3.dressed(() => {
    nominal.paint(colour('nominal'), colour('nominal'));
    deformed.paint(colour('arm'), colour('arm-joint'));
    cloud.paint({ path: colour('path'), ring: colour('accent') });
  });
  const most = Math.max(scene.data.worst_before_mm || worstDrawn(course), 1e-6);
  const error = new Float64Array(3);
  let areErrorsStale = true;
  const refresh = view3.beforePicture(() => {
    const { t, times, corrected, point } = state;
    if (areErrorsStale) {
      const shares = corrected ? scene.correction.leftShares(t) : course.at(t);
      cloud.show((i, e) => course.error(i, shares, e), times, most);
      areErrorsStale = false;
    }
    cloud.arrows.visible = state.arrows !== false;
    cloud.path.visible = state.path !== false;
    cloud.mark(point);
    pose();
  });
  const hud = h('p', { class: 'hud', role: 'status' });
  function pose() {
    const q = state.joints ?? course.joints(0);
    const tool = course.tool(state.point ?? 0);
    const deviation = course.deviation(state.point ?? 0, state.t);
    const meant = nominal.pose(q, tool);
    const really = deformed.pose(q, tool, deviation);
    deformed.pose(q, tool, deviation, state.times);
    const off = Math.hypot(...really.map((value, k) => value - meant[k]));
    const isAway = course.isByTarget && q.some((value, j) => value !== course.joints(state.point ?? 0)[j]);
    const how = course.hasModel && !course.model ? '' : `, off by ${mm(off)} mm${isAway ? ' with the deformation at the target' : ''}`;
    hud.textContent = `TCP ${meant.map((value) => value.toFixed(1)).join(', ')} mm${how}`;
  }
  // another target or pose leaves the errors of all targets as they are
  const refreshErrors = () => {
    areErrorsStale = true;
    refresh();
  };
  state.on('t times corrected', refreshErrors);
  state.on('point arrows path joints', refresh);
  onTheme(refreshErrors);
  state.on('point', () => { if (state.point !== null) state.set({ joints: course.joints(state.point) }); });
  view3.onPick(() => cloud.dots, (i) => state.set({ point: i }));
  look(view3, course);
  refresh();
  // what a program that drives the page needs to click on a target
  view3.canvas.windowPlace = (i) => view3.toWindow(course.position(i));
  return section('arm', title, 'Arm',
    h('div', { class: 'stage' }, h('div', { class: 'screen' }, view3.element, hud, legend(most, state)), panel),
    modelNotice(course),
    card);
}

/** What of an identified model the picture of the arm holds. */
function modelNotice(course) {
  if (!course.hasModel) return null;
  const text = (() => {
    if (!course.model) return 'Errors at the targets hold all that the identified model adds. Of so many targets the page holds no deformation for each: the arm is drawn with the offsets of the deformation table alone.';
    if (course.isByTarget) return 'The arm is drawn with the deformation table and all that the identified model adds at the chosen target and minute: load, direction and joints of that target included. Jogged away from it, it keeps that deformation: what the model would give there is not on the page.';
    return 'The arm is drawn with the deformation table and all that the identified model adds at the minute; it is the same wherever the arm stands.';
  })();
  return h('p', { class: 'notice', 'data-name': 'model-notice', text });
}

/** Base, arm upright and targets in one picture. */
function look(view3, course) {
  const low = [-250, -250, 0];
  const high = [250, 250, 700];
  for (let i = 0; i < course.count; i += 1) {
    course.position(i).forEach((value, k) => { low[k] = Math.min(low[k], value); high[k] = Math.max(high[k], value); });
  }
  view3.lookAt(low, high);
}

function timeControl({ course, state }) {
  const step = course.end > 20 ? 1 : course.end / 100;
  const minute = slider({
    label: course.byTemperature ? 'Temperature' : 'Warm-up minute', name: 'minute', min: 0, max: course.end, step, value: state.t,
    show: (t) => `${number(course.from + t)} ${course.unit}`, on: (t) => state.set({ t }),
  });
  state.on('t', () => minute.set(state.t));
  let from = null;
  const play = button('Play', () => (from === null ? start() : stop()), { name: 'play', class: 'small' });
  const stop = () => { from = null; play.textContent = 'Play'; };
  function start() {
    const begin = state.t >= course.end ? 0 : state.t;
    from = performance.now() - (begin / course.end) * PLAY_S * 1000;
    play.textContent = 'Pause';
    requestAnimationFrame(frame);
  }
  function frame(now) {
    if (from === null) return;
    const t = ((now - from) / (PLAY_S * 1000)) * course.end;
    state.set({ t: Math.min(step === 1 ? Math.round(t) : t, course.end) });
    if (t >= course.end) stop();
    else requestAnimationFrame(frame);
  }
  return h('div', { class: 'row' }, minute.element, play);
}

function enlargement({ state }) {
  return slider({
    label: 'Deformation enlarged', name: 'times', min: 0, max: STEPS, step: 1, value: valueOf(state.times),
    show: (value) => `${timesOf(value)} ×`, on: (value) => state.set({ times: timesOf(value) }),
  }).element;
}

function shows({ state }) {
  return h('div', { class: 'shows' },
    choice({ label: 'Errors', name: 'corrected', options: [['no', 'uncorrected'], ['yes', 'corrected']], value: 'no', on: (key) => state.set({ corrected: key === 'yes' }) }),
    h('div', { class: 'checks' },
      check({ label: 'arrows', name: 'arrows', value: true, on: (arrows) => state.set({ arrows }) }),
      check({ label: 'path', name: 'path', value: true, on: (path) => state.set({ path }) })));
}

function jog({ course, state }, arm) {
  const sliders = arm.joints.map((joint, i) => {
    const [min, max] = joint.range ?? [-360, 360];
    return slider({
      label: `J${i + 1}`, name: `joint-${i + 1}`, min, max, step: 0.1, value: (state.joints ?? course.joints(0))[i], show: (q) => `${deg(q, 1)}°`,
      on: (q) => {
        const joints = [...(state.joints ?? course.joints(0))];
        joints[i] = q;
        state.set({ joints });
      },
    });
  });
  state.on('joints', () => sliders.forEach((one, i) => one.set(state.joints[i])));
  return h('fieldset', { class: 'jog' }, h('legend', { text: 'Jog' }), sliders.map((one) => one.element),
    button('Back to the target', () => state.set({ joints: course.joints(state.point ?? 0) }), { class: 'small' }));
}

/** The largest error of a target when all has settled, mm: of a program of which no target is corrected. */
function worstDrawn(course) {
  const shares = course.at(course.end);
  return Array.from({ length: course.count }, (_, i) => Math.hypot(...course.error(i, shares))).reduce((most, one) => Math.max(most, one), 0);
}

function legend(most, state) {
  const label = h('span', { text: `${mm(most, 3)} mm` });
  return h('p', { class: 'scale' }, h('span', { text: '0' }), h('span', { class: 'ramp', 'aria-hidden': 'true' }), label);
}
