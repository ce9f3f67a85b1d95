// Changed lines side by side, with filters by text, bucket and size of the correction.

import { beforehand, count, h, mm, plural } from './dom.js';
import { length } from './course.js';
import { button, search, select } from './controls.js';
import { later, section } from './layout.js';
import { PRINTED, printedRows } from './paper.js';

const PAGE = 40;

/** Every line that is shown of a program's files: `{ file, line, start, old, now, end }`; where the old piece stays in the new one, only what is around it is written. */
function linesOf(view) {
  const { shared, files } = view.source;
  return files.flatMap((file) => file.rows.map(([line, start, old, now, end]) => ({ file: file.path, line, start: shared[start], old, now: Array.isArray(now) ? now.join(old) : now, end: shared[end] })));
}

/** The line of a motion; `null` where the page does not hold it. */
export function lineOf(scene, motion) {
  if (!scene.lines) {
    scene.lines = scene.view.source ? linesOf(scene.view) : [];
    scene.lineAt = new Map(scene.lines.map((row) => [`${row.file}:${row.line}`, row]));
  }
  return scene.lineAt.get(`${motion.file}:${motion.line}`) ?? null;
}

const code = (row, text, tag) => h('code', {}, row.start.trimStart(), text !== '' && h(tag, { text }), row.end);

const original = (row) => (row.now === null ? h('code', { text: (row.start + row.old + row.end).trimStart() }) : code(row, row.old, 'del'));
const changed = (row) => (row.now === null ? h('code', { class: 'same', text: 'stays as it is' }) : code(row, row.now, 'ins'));

/** A line as it was and as it is. */
export function sourceLine(row) {
  if (!row) return h('p', { class: 'calm', text: 'its line is not on this page' });
  return h('div', { class: 'pair' }, h('div', { class: 'side' }, original(row)), h('div', { class: 'side' }, changed(row)));
}

export function sourceSection(scene) {
  const { view, data, course, correction } = scene;
  lineOf(scene, {});
  const motionAt = new Map(data.motions.map((motion) => [`${motion.file}:${motion.line}`, motion]));
  const pointOf = new Map(course ? course.points.motion.map((index, i) => [index, i]) : []);
  const filter = { text: '', bucket: '', least: 0 };
  let page = 0;
  let shown = [];
  const body = h('div', { class: 'diff-rows' });
  const status = h('p', { class: 'status', role: 'status' });
  const previous = button('Previous', () => turn(-1), { class: 'small' });
  const next = button('Next', () => turn(1), { class: 'small' });

  const motionOf = (row) => motionAt.get(`${row.file}:${row.line}`);
  /** How far a line's motion is moved, in the chosen bucket or at most, mm. */
  function correctionOf(motion) {
    if (!motion || motion.status !== 'compensated') return null;
    const point = pointOf.get(motion.index);
    if (filter.bucket === '' || point === undefined) return { size: motion.max_correction_mm };
    const by = course.error(point, correction.buckets[Number(filter.bucket)].shares).map((value) => -value);
    return { size: length(by), by };
  }

  const textOf = (row, motion) => {
    row.text ??= `${row.file}:${row.line} ${row.start}${row.old}${row.end} ${row.now ?? ''} ${motion?.target ?? ''} ${motion?.routine ?? ''}`.toLowerCase();
    return row.text;
  };

  function arrange() {
    const wanted = filter.text.trim().toLowerCase();
    shown = scene.lines.filter((row) => {
      const motion = motionOf(row);
      if (filter.least > 0 && !((correctionOf(motion)?.size ?? 0) >= filter.least)) return false;
      if (!wanted) return true;
      return textOf(row, motion).includes(wanted);
    });
    page = 0;
    draw();
  }

  function draw() {
    const pages = Math.max(Math.ceil(shown.length / PAGE), 1);
    const rows = shown.slice(page * PAGE, (page + 1) * PAGE);
    fill(rows);
    const all = scene.lines.length;
    const said = shown.length === all ? plural(all, 'line') : `${count(shown.length)} of ${plural(all, 'line')}`;
    status.textContent = pages > 1 ? `${said}, page ${count(page + 1)} of ${count(pages)}` : said;
    previous.disabled = page === 0;
    next.disabled = page >= pages - 1;
    pager.hidden = pages < 2;
  }

  function fill(rows) {
    let file = null;
    body.replaceChildren(...rows.flatMap((row) => {
      const head = row.file === file ? [] : [h('p', { class: 'diff-file' }, h('span', { text: row.file }), arrow(row.file))];
      file = row.file;
      const one = correctionOf(motionOf(row));
      const size = one ? h('span', { class: 'size', text: one.by ? `${one.by.map((value) => mm(value)).join(', ')} mm` : `${mm(one.size)} mm` }) : null;
      return [...head, h('div', { class: row.now === null ? 'diff-row same' : 'diff-row' },
        h('span', { class: 'line', text: row.line }), h('div', { class: 'side old' }, original(row)), h('div', { class: 'side new' }, changed(row), size))];
    }));
    if (rows.length === 0) body.append(h('p', { class: 'empty', text: 'no line matches' }));
  }

  const results = new Map(view.source.files.map((file) => [file.path, file.result]));
  const arrow = (path) => (results.get(path) ? h('span', { class: 'result', text: ` → ${results.get(path)}` }) : null);

  function turn(by) {
    page += by;
    draw();
  }

  const set = (changedFilter) => { Object.assign(filter, changedFilter); arrange(); };
  const borders = (bucket) => `${bucket.index}: ${bucket.from_min} to ${bucket.to_min ?? '∞'} min`;
  const pager = h('div', { class: 'pager' }, previous, next);
  const bar = h('div', { class: 'bar' },
    search({ label: 'Motion, routine or text', name: 'source-search', on: (text) => set({ text }) }),
    course && correction.inBuckets && select({
      label: 'Correction of bucket', name: 'source-bucket', value: '', options: [['', 'largest of all'], ...correction.buckets.map((bucket, i) => [String(i), borders(bucket)])],
      on: (bucket) => set({ bucket }),
    }),
    search({ label: 'At least, mm', name: 'source-least', type: 'number', on: (text) => set({ least: Number(text) || 0 }) }),
    status, pager);
  addEventListener('beforeprint', () => {
    fill(shown.slice(0, PRINTED));
    status.textContent = printedRows(shown.length, scene.lines.length, 'line');
  });
  addEventListener('afterprint', draw);
  arrange();
  beforehand(scene.lines.length, (i) => textOf(scene.lines[i], motionOf(scene.lines[i])));
  const leftOut = view.source.files.reduce((sum, file) => sum + file.left_out, 0);
  return section('source', 'Source, line by line', 'Source', bar,
    h('div', { class: 'diff', tabIndex: 0, role: 'group', 'aria-label': 'Source before and after' }, body),
    leftOut > 0 && h('p', { class: 'notice', text: `${plural(leftOut, 'more changed line')} are not on this page; --diff FILE writes all.` }),
    added(view.source.files));
}

function added(files) {
  const blocks = files.flatMap((file) => file.added.map((block) => ({ path: file.result ?? file.path, ...block })));
  if (blocks.length === 0) return null;
  const lines = blocks.reduce((sum, block) => sum + block.lines, 0);
  return later(`${plural(lines, 'line')} added in ${plural(blocks.length, 'place')}: comment block, data and routines whose names begin with tc`, () => h('div', {},
    blocks.slice(0, 60).map((block) => h('div', { class: 'added' },
      h('p', { class: 'diff-file', text: `${block.path}, after line ${block.after} of the source: ${plural(block.lines, 'line')}` }),
      h('pre', { tabIndex: 0, text: block.text.join('\n') + (block.lines > block.text.length ? `\n… ${plural(block.lines - block.text.length, 'more line')}` : '') })))));
}
