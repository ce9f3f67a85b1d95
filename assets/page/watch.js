// The page of `driftpost link watch`: how the corrected programs stand, and how they came there. It loads itself anew while the watch goes on.

import { count, h, number, plural } from './dom.js';
import { curves } from './curves.js';
import { figure, figures, later, messages, record, section } from './layout.js';
import { table } from './table.js';
import { check } from './controls.js';
import { onTheme, setTheme } from './theme.js';

/** As many times as long as it is written nothing new came: then the watch is taken to have ended. */
const MISSED = 4;
const LABELS = { tcMinute: ['Warm-up minute', 'min'], tcDegrees: ['Temperature', '°C'], tcBucket: ['Bucket', ''], tcShare: ['Share of the drift', ''], tcTouchSigma: ['Known by touch to', ''], tcTouchAge: ['Touched', 'min ago'] };

/** What an operator has set, in words. */
function modeWords(mode, isShare) {
  if (mode === -1) return 'follows the clock';
  if (mode === -2) return 'originals';
  if (isShare && mode >= 0 && mode <= 100) return `held at ${number(mode)} %`;
  if (!isShare && mode >= 0) return `held at bucket ${number(mode)}`;
  return 'none that there is: originals';
}

const shown = (value) => (typeof value === 'number' ? number(value) : String(value));
// Why it runs them where it cannot follow the drift, the module says in words alone.
const isOriginals = ({ values, said }) => values.tcBucket === -1 || values.tcMode === -2 || Boolean(said?.includes('original targets'));

export function watched({ data, title, version }) {
  const programs = [...new Set(data.records.map((one) => `${one.task}/${one.module}`))];
  const of = new Map(programs.map((name) => [name, data.records.filter((one) => `${one.task}/${one.module}` === name)]));
  const last = programs.map((name) => of.get(name).at(-1));
  const sections = [
    () => section('now', 'Now', 'Now', fresh(data), programs.map((name) => now(name, of.get(name).at(-1))),
      data.warnings.length > 0 && [h('h3', { class: 'apart', text: plural(data.warnings.length, 'warning') }), messages([...data.warnings].reverse().map((one) => ({ code: `second ${number(one.t_s)}`, message: one.text })), 'warn')]),
    ...programs.map((name) => () => course(name, of.get(name))),
    () => record([['controller', title], ['looks', data.shown < data.seen ? `${count(data.seen)}, of which ${count(data.shown)} are on this page: older ones are thinned out` : count(data.seen)]], version),
  ];
  const state = last.map((one) => (isOriginals(one) ? 'original targets' : 'corrected')).join(', ');
  const worries = last.some((one) => one.said || isOriginals(one)) || data.warnings.length > 0 || data.ended;
  return { kind: 'link watch', verdict: state || 'nothing seen yet', tone: worries ? 'warn' : 'good', sections };
}

/** When it was written, and the switch that lets it load itself anew. */
function fresh(data) {
  const written = new Date(data.written_s * 1000);
  const status = h('p', { class: 'calm', 'data-name': 'fresh', role: 'status' });
  const kept = new URLSearchParams(location.hash.slice(1));
  if (kept.has('theme')) setTheme(kept.get('theme'));
  let goesOn = !data.ended && !kept.has('hold');
  const keep = () => {
    const now = new URLSearchParams();
    if (document.documentElement.dataset.theme) now.set('theme', document.documentElement.dataset.theme);
    if (!goesOn && !data.ended) now.set('hold', '1');
    if (scrollY > 0) now.set('y', String(Math.round(scrollY)));
    history.replaceState(null, '', `#${now}`);
  };
  onTheme(keep);
  const age = () => (Date.now() - written) / 1000;
  const tell = () => {
    const at = `As of ${written.toLocaleString()}`;
    if (data.ended) status.textContent = `${at}. ${data.ended}`;
    else if (age() > MISSED * data.every_s) status.textContent = `${at}: ${Math.round(age())} seconds old. Nothing new has been written since: the watch may have ended.`;
    else status.textContent = `${at}; written anew every ${number(data.every_s)} seconds.`;
  };
  tell();
  setInterval(tell, 1000);
  setInterval(() => {
    if (!goesOn || document.hidden) return;
    keep();
    location.reload();
  }, data.every_s * 1000);
  if (kept.has('y')) addEventListener('page-whole', () => scrollTo(0, Number(kept.get('y'))), { once: true });
  return [status, !data.ended && check({ label: `load the page anew every ${number(data.every_s)} seconds`, name: 'reload', value: goesOn, on: (value) => { goesOn = value; keep(); } })];
}

function now(name, { values, said }) {
  const { tcMode: mode, ...others } = values;
  return [
    h('h3', { class: 'apart', text: name }),
    said && messages([{ code: 'it said', message: said }], 'warn'),
    figures(
      mode !== undefined && figure('tcMode', shown(mode), '', modeWords(mode, 'tcShare' in values)),
      Object.entries(others).map(([key, value]) => figure(LABELS[key]?.[0] ?? key, key === 'tcBucket' && value === -1 ? 'originals' : shown(value), key === 'tcBucket' ? '' : LABELS[key]?.[1], key))),
  ];
}

function course(name, records) {
  const minutes = records.map((one) => one.t_s / 60);
  const keys = Object.keys(records.at(-1).values).filter((key) => key !== 'tcMode' && records.some((one) => typeof one.values[key] === 'number'));
  const changes = records.filter((one, i) => i === 0 || ['tcMode', 'tcBucket'].some((key) => one.values[key] !== records[i - 1].values[key]) || one.said !== records[i - 1].said);
  const columns = [
    { key: 't', label: 'minute of the watch', number: true, value: (one) => one.t_s, text: (one) => (one.t_s / 60).toFixed(2) },
    ...Object.keys(records.at(-1).values).map((key) => ({ key, label: key, number: true, value: (one) => one.values[key], text: (one) => shown(one.values[key]) })),
    { key: 'said', label: 'it said', value: (one) => one.said ?? '', text: (one) => one.said ?? '', class: 'reason' },
  ];
  const dots = records.length === 1;
  return section(`course-${name.replace(/\W/g, '-')}`, `${name}: how it went`, name.split('/')[1],
    h('div', { class: 'plots' }, keys.map((key) => curves({
      title: LABELS[key]?.[0] ?? key, x: minutes, xLabel: 'minutes of the watch', yLabel: LABELS[key]?.[1] || key, height: 210, zero: key !== 'tcDegrees',
      text: `${key} from ${shown(records[0].values[key])} to ${shown(records.at(-1).values[key])}`,
      series: [{ label: key, colour: 'after', dots, values: records.map((one) => (typeof one.values[key] === 'number' ? one.values[key] : null)) }],
    }).element)),
    h('h3', { class: 'apart', text: 'Changes of mode, bucket and message' }),
    table({ caption: 'Changes', name: 'changes', columns, rows: [...changes].reverse(), searchable: false }).element,
    later('All looks', () => table({ caption: 'Looks', name: 'looks', columns, rows: [...records].reverse(), searchable: false }).element));
}
