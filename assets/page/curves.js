// Curves by uPlot, in the page's colours, as wide as their place.

import uPlot from 'uplot';
import { h, oncePerFrame } from './dom.js';
import { colour, onTheme } from './theme.js';

const FONT = '12px system-ui, sans-serif';

/**
 * Series are `{ label, values, colour, dash, dots, width }`; `marks` are vertical lines `{ at, colour, dash, label }` that stay;
 * `needle` says where the one line stands that follows the reader, or null; `text` is what is told instead of the picture.
 */
export function curves({ title, text, x, xLabel, yLabel, series, marks = () => [], needle = () => null, height = 240, onClick, zero = true }) {
  const place = h('div', { class: 'plot' });
  const legend = h('ul', { class: 'legend' });
  const element = h('figure', { class: 'curves' }, h('figcaption', { text: title }), legend,
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
      label: one.label, stroke: () => colour(one.colour), width: one.dots ? 0 : (one.width ?? 2), dash: one.dash,
      paths: one.dots ? () => null : undefined, spanGaps: !one.gaps,
      points: { show: Boolean(one.dots), size: one.size ?? 5, fill: () => colour(one.colour), stroke: () => colour(one.colour), width: 0 },
    }));
    return {
      width, height, legend: { show: false }, cursor: { drag: { x: true, y: false }, points: { show: !now.some((one) => one.dots) } },
      scales: { x: { time: false }, y: { range: (_, low, high) => range(low, high, zero) } },
      axes: [axis(xLabel, 34), { ...axis(yLabel, 52), values: (_, ticks) => ticks.map((tick) => String(Number(tick.toPrecision(6)))) }],
      series: [{}, ...own], hooks: { draw: [drawMarks, placeNeedle] },
    };
  }

  function drawMarks(u) {
    const { ctx, bbox } = u;
    ctx.save();
    for (const mark of marks()) {
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

/** From zero, or a little more than what there is. */
function range(low, high, zero) {
  if (!Number.isFinite(low) || !Number.isFinite(high)) return [0, 1];
  const from = zero ? Math.min(low, 0) : low;
  const room = Math.max((high - from) * 0.06, 1e-6);
  return [zero && low >= 0 ? 0 : from - room, high + room];
}

function swatch(one) {
  const mark = h('span', { class: `swatch${one.dots ? ' dot' : ''}${one.dash ? ' dash' : ''}`, 'aria-hidden': 'true' });
  mark.style.setProperty('--swatch', `var(--${one.colour})`);
  return mark;
}
