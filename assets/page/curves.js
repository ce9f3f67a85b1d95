// Curves by uPlot, in the page's colours, as wide as their place.

import uPlot from 'uplot';
import { h, oncePerFrame } from './dom.js';
import { MarkLabels } from './mark_labels.js';
import { colour, onTheme } from './theme.js';

const FONT = '12px system-ui, sans-serif';
/** From tick to tick of what is counted. */
const WHOLE = [1, 10, 100, 1e3, 1e4, 1e5].flatMap((ten) => [1, 2, 5].map((n) => n * ten));

/**
 * Series are `{ label, values, colour, dash, dots, bars, width, gaps }`; `right` is a second scale `{ label, factor }` of the same values,
 * `names` stand at 0, 1, 2 ... below; `whole`: x counts things;
 * `marks` are vertical lines `{ at, colour, dash, label, to, shade }`
 * that stay, with their word above the plot, shaded up to `to`;
 * `needle` says where the one line stands that follows the reader, or null; `text` is what is told instead of the picture.
 */
export function curves({ title, text, x, xLabel, yLabel, series, marks = () => [], needle = () => null, height = 240, onClick, zero = true, right = null, names = null, whole = false }) {
  const place = h('div', { class: 'plot' });
  const legend = h('ul', { class: 'legend' });
  const labels = marks().some((mark) => mark.label) ? new MarkLabels() : null;
  const element = h('figure', { class: 'curves' }, h('figcaption', { text: title }), legend, labels?.element ?? [],
    h('div', { role: 'img', 'aria-label': text }, place));
  const line = h('div', { class: 'needle', hidden: true });
  let plot = null;
  let now = series;
  let seen = true;
  let stale = false;

  const axis = (label, size) => ({
    label, labelSize: 22, size, font: FONT, labelFont: FONT, stroke: () => colour('muted'), grid: { stroke: () => colour('line'), width: 1 },
    ticks: { stroke: () => colour('line'), width: 1 },
  });

  function options(width) {
    const own = now.map((one) => ({
      label: one.label, stroke: () => colour(one.colour), width: one.dots || one.bars ? 0 : (one.width ?? 2), dash: one.dash,
      paths: one.dots ? () => null : one.bars ? uPlot.paths.bars({ size: [0.6, 9] }) : undefined, fill: one.bars ? () => colour(one.colour) : undefined, spanGaps: !one.gaps,
      points: { show: Boolean(one.dots), size: one.size ?? 5, fill: () => colour(one.colour), stroke: () => colour(one.colour), width: 0 },
    }));
    return {
      width, height, padding: labels ? [5, null, null, null] : undefined, legend: { show: false }, cursor: { drag: { x: true, y: false }, points: { show: !now.some((one) => one.dots) } },
      scales: { x: { time: false, ...(names && { range: [0.5, names.length - 1.5] }), ...(whole && { range: (_, low, high) => [low - 0.5, high + 0.5] }) }, y: { range: (_, low, high) => range(low, high, zero) } },
      axes: [{ ...axis(xLabel, 34), ...(whole && { incrs: WHOLE }), ...(names && { splits: () => names.map((_, i) => i).filter((i) => names[i] !== ''), values: (_, at) => at.map((i) => names[i]) }) }, { ...axis(yLabel, 52), values: plainly }, ...(right ? [{ ...axis(right.label, 64), side: 1, grid: { show: false }, values: (u, ticks) => plainly(u, ticks.map((tick) => Number((tick * right.factor).toPrecision(2)))) }] : [])],
      series: [{}, ...own], hooks: { drawAxes: [drawShades], draw: [drawMarks, placeNeedle], setScale: labels ? [placeLabels] : [], ready: labels ? [placeLabels] : [] },
    };
  }

  /** Behind the curves: from a mark to where it ends. */
  function drawShades({ ctx, bbox, valToPos }) {
    for (const mark of marks().filter((one) => one.shade)) {
      const [from, to] = [mark.at, mark.to].map((at) => Math.min(Math.max(valToPos(at, 'x', true), bbox.left), bbox.left + bbox.width));
      ctx.save();
      ctx.fillStyle = colour(mark.shade);
      ctx.fillRect(from, bbox.top, to - from, bbox.height);
      ctx.restore();
    }
  }

  function placeLabels(u) {
    const left = u.over.offsetLeft;
    labels.show(marks(), (at) => left + u.valToPos(at, 'x'), [left, left + u.over.clientWidth], place.clientWidth);
  }

  function drawMarks(u) {
    const { ctx, bbox } = u;
    ctx.save();
    for (const mark of marks().filter((one) => one.colour)) {
      const at = Math.round(u.valToPos(mark.at, 'x', true)) + 0.5;
      if (at < bbox.left || at > bbox.left + bbox.width) continue;
      ctx.strokeStyle = colour(mark.colour);
      ctx.setLineDash(mark.dash ?? []);
      ctx.lineWidth = mark.width ?? 1;
      ctx.beginPath();
      ctx.moveTo(at, bbox.top);
      ctx.lineTo(at, bbox.top + bbox.height);
      ctx.stroke();
    }
    ctx.restore();
  }

  /** The needle is no part of the picture: where it goes, nothing is drawn anew. */
  function placeNeedle() {
    const at = needle();
    const left = at === null ? NaN : plot?.valToPos(at, 'x') ?? NaN;
    line.hidden = !(left >= 0 && left <= plot.over.clientWidth);
    if (!line.hidden) line.style.transform = `translateX(${left.toFixed(1)}px)`;
  }

  function build() {
    const width = place.clientWidth;
    if (width === 0) return;
    plot?.destroy();
    plot = new uPlot(options(width), [x, ...now.map((one) => one.values)], place);
    plot.over.append(line);
    if (onClick) {
      plot.over.addEventListener('click', () => {
        if (plot.cursor.idx !== null && plot.cursor.idx !== undefined) onClick(x[plot.cursor.idx], plot.cursor.idx);
      });
    }
    legend.replaceChildren(...now.filter((one) => one.label).map((one) => h('li', {}, swatch(one), one.label)));
  }

  const rebuild = oncePerFrame(build);
  /** In other colours: what nobody sees waits until it is looked at. */
  const recolour = () => {
    stale = !seen;
    if (seen) plot?.redraw(false);
  };
  onTheme(recolour);
  new IntersectionObserver(([entry]) => {
    seen = entry.isIntersecting;
    if (seen && stale) recolour();
  }).observe(place);
  addEventListener('beforeprint', () => { if (stale) plot?.redraw(false); });
  new ResizeObserver(() => {
    if (plot && plot.width === place.clientWidth) return;
    rebuild();
  }).observe(place);
  return {
    element,
    follow: oncePerFrame(placeNeedle),
    show(changed) {
      const same = changed.length === now.length && changed.every((one, i) => one.label === now[i].label);
      now = changed;
      if (same) plot?.setData([x, ...now.map((one) => one.values)]);
      else rebuild();
    },
  };
}

const plainly = (_, ticks) => ticks.map((tick) => String(Number(tick.toPrecision(6))));

/** From zero, or a little more than what there is. */
function range(low, high, zero) {
  if (!Number.isFinite(low) || !Number.isFinite(high)) return [0, 1];
  if (zero && low === 0 && high === 0) return [0, 1];
  const [from, to] = zero ? [Math.min(low, 0), Math.max(high, 0)] : [low, high];
  const room = Math.max((to - from) * 0.06, 1e-6);
  return [zero && low >= 0 ? 0 : from - room, zero && high <= 0 ? 0 : to + room];
}

function swatch(one) {
  const mark = h('span', { class: `swatch${one.dots ? ' dot' : ''}${one.dash ? ' dash' : ''}`, 'aria-hidden': 'true' });
  mark.style.setProperty('--swatch', `var(--${one.colour})`);
  return mark;
}
