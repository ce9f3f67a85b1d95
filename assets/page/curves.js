// Curves by uPlot, in the page's colours, as wide as their place.

import uPlot from 'uplot';
import { h, oncePerFrame } from './dom.js';
import { colour, onTheme } from './theme.js';

const FONT = '12px system-ui, sans-serif';

/**
 * Series are `{ label, values, colour, dash, dots, width }`; `marks` gives vertical lines `{ at, colour, dash }`;
 * `text` is what is told instead of the picture.
 */
export function curves({ title, text, x, xLabel, yLabel, series, marks = () => [], height = 240, onClick, zero = true }) {
  const place = h('div', { class: 'plot' });
  const legend = h('ul', { class: 'legend' });
  const element = h('figure', { class: 'curves' }, h('figcaption', { text: title }), legend,
    h('div', { role: 'img', 'aria-label': text }, place));
  let plot = null;
  let now = series;

  const axis = (label, size) => ({
    label, labelSize: 22, size, font: FONT, labelFont: FONT, stroke: colour('muted'), grid: { stroke: colour('line'), width: 1 },
    ticks: { stroke: colour('line'), width: 1 },
  });

  function options(width) {
    const own = now.map((one) => ({
      label: one.label, stroke: colour(one.colour), width: one.dots ? 0 : (one.width ?? 2), dash: one.dash,
      paths: one.dots ? () => null : undefined, spanGaps: !one.gaps,
      points: { show: Boolean(one.dots), size: one.size ?? 5, fill: colour(one.colour), stroke: colour(one.colour), width: 0 },
    }));
    return {
      width, height, legend: { show: false }, cursor: { drag: { x: true, y: false }, points: { show: !now.some((one) => one.dots) } },
      scales: { x: { time: false }, y: { range: (_, low, high) => range(low, high, zero) } },
      axes: [axis(xLabel, 34), { ...axis(yLabel, 52), values: (_, ticks) => ticks.map((tick) => String(Number(tick.toPrecision(6)))) }],
      series: [{}, ...own], hooks: { draw: [drawMarks] },
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

  function build() {
    const width = place.clientWidth;
    if (width === 0) return;
    plot?.destroy();
    plot = new uPlot(options(width), [x, ...now.map((one) => one.values)], place);
    if (onClick) {
      plot.over.addEventListener('click', () => {
        if (plot.cursor.idx !== null && plot.cursor.idx !== undefined) onClick(x[plot.cursor.idx], plot.cursor.idx);
      });
    }
    legend.replaceChildren(...now.filter((one) => one.label).map((one) => h('li', {}, swatch(one), one.label)));
  }

  const rebuild = oncePerFrame(build);
  onTheme(rebuild);
  new ResizeObserver(() => {
    if (plot && plot.width === place.clientWidth) return;
    rebuild();
  }).observe(place);
  return {
    element,
    redraw: oncePerFrame(() => plot?.redraw(false)),
    show(changed) {
      now = changed;
      rebuild();
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
