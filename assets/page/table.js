// A table that is sorted by its headings, searched, and shown a page at a time; whole in print as far as it is short, and it says where it is not.

import { NONE, beforehand, count, h, plural } from './dom.js';
import { button, search } from './controls.js';
import { PRINTED, printedRows } from './paper.js';

const PAGE = 40;

/**
 * Columns are `{ key, label, value(row), text(row), number }`; `onRow(row)` makes rows that can be chosen.
 */
export function table({ caption, columns, rows, onRow, name, sort, empty = 'nothing here', searchable = true, rowClass }) {
  let shown = rows;
  let by = sort ?? null;
  let page = 0;
  let chosen = null;
  let drawn = new Map();
  let wanted = '';
  const texts = new Array(rows.length);
  const at = new Map(rows.map((row, i) => [row, i]));
  const textOf = (row) => {
    const i = at.get(row);
    texts[i] ??= columns.map((column) => column.text(row)).join('\u0001').toLowerCase();
    return texts[i];
  };

  const body = h('tbody');
  const status = h('p', { class: 'status', role: 'status' });
  const previous = button('Previous', () => turn(-1), { class: 'small' });
  const next = button('Next', () => turn(1), { class: 'small' });
  const headings = columns.map((column) => {
    const mark = h('span', { class: 'mark', 'aria-hidden': 'true' });
    const heading = h('th', { scope: 'col', class: column.number ? 'number' : '' },
      h('button', { type: 'button', class: 'sort', onclick: () => sortBy(column) }, column.label, mark));
    return { column, heading, mark };
  });

  function cells(row) {
    return columns.map((column, k) => {
      const text = column.text(row);
      const content = k === 0 && onRow ? h('button', { type: 'button', class: 'link', text: text || NONE, onclick: () => onRow(row) }) : text;
      return h('td', { class: `${column.number ? 'number' : ''} ${column.class ?? ''}`.trim(), title: String(text).length > 24 ? text : undefined }, content);
    });
  }

  /** Shows whether a row that is drawn is the chosen one. */
  function mark(row) {
    const element = drawn.get(row);
    if (!element) return;
    element.classList.toggle('chosen', row === chosen);
    if (row === chosen) element.setAttribute('aria-current', 'true');
    else element.removeAttribute('aria-current');
  }

  function fill(from, to) {
    drawn = new Map(shown.slice(from, to).map((row) => [row, h('tr', {
      class: rowClass?.(row) || undefined,
      onclick: onRow ? (event) => { if (event.target.tagName !== 'BUTTON') onRow(row); } : undefined,
    }, cells(row))]));
    body.replaceChildren(...drawn.values());
    mark(chosen);
    if (shown.length === 0) body.append(h('tr', {}, h('td', { colSpan: columns.length, class: 'empty', text: rows.length ? 'no row matches' : empty })));
  }

  function draw() {
    const pages = Math.max(Math.ceil(shown.length / PAGE), 1);
    page = Math.min(Math.max(page, 0), pages - 1);
    fill(page * PAGE, (page + 1) * PAGE);
    const rowsSaid = shown.length === rows.length ? plural(rows.length, 'row') : `${count(shown.length)} of ${plural(rows.length, 'row')}`;
    status.textContent = pages > 1 ? `${rowsSaid}, page ${count(page + 1)} of ${count(pages)}` : rowsSaid;
    previous.disabled = page === 0;
    next.disabled = page >= pages - 1;
    pager.hidden = pages < 2;
    for (const { column, heading, mark } of headings) {
      const up = by?.key === column.key ? by.up : null;
      heading.setAttribute('aria-sort', up === null ? 'none' : up ? 'ascending' : 'descending');
      mark.textContent = up === null ? '' : up ? ' ▲' : ' ▼';
    }
  }

  function arrange() {
    shown = wanted ? rows.filter((row) => textOf(row).includes(wanted)) : [...rows];
    const column = by && columns.find((one) => one.key === by.key);
    if (column) {
      const keyed = shown.map((row) => [column.value(row), row]);
      const order = (a, b) => {
        if (a === b) return 0;
        if (a === null || a === undefined) return 1;
        if (b === null || b === undefined) return -1;
        return (a < b ? -1 : 1) * (by.up ? 1 : -1);
      };
      keyed.sort((a, b) => order(a[0], b[0]));
      shown = keyed.map(([, row]) => row);
    }
    draw();
  }

  function sortBy(column) {
    // numbers largest first, names from A
    const first = !column.number;
    by = by?.key === column.key ? { key: column.key, up: !by.up } : { key: column.key, up: first };
    page = 0;
    arrange();
  }

  function turn(by_pages) {
    page += by_pages;
    draw();
  }

  const pager = h('div', { class: 'pager' }, previous, next);
  const find = searchable && rows.length > 8
    ? search({ label: `Search ${caption.toLowerCase()}`, name: `${name}-search`, on: (text) => { wanted = text.trim().toLowerCase(); page = 0; arrange(); } })
    : null;
  // what is searched is spelled out before anybody searches
  if (find) beforehand(rows.length, (i) => textOf(rows[i]));
  addEventListener('beforeprint', () => {
    fill(0, PRINTED);
    status.textContent = printedRows(shown.length, rows.length, 'row');
  });
  addEventListener('afterprint', draw);
  arrange();
  return {
    element: h('div', { class: 'table', 'data-name': name }, h('div', { class: 'bar' }, find, status, pager),
      h('div', { class: 'scroll', tabIndex: 0, role: 'group', 'aria-label': caption },
        h('table', {}, h('caption', { class: 'hidden', text: caption }), h('thead', {}, h('tr', {}, headings.map((one) => one.heading))), body))),
    choose(row) {
      if (row === chosen) return;
      const before = chosen;
      chosen = row;
      const place = shown.indexOf(row);
      if (place >= 0 && !drawn.has(row)) {
        page = Math.floor(place / PAGE);
        draw();
      }
      mark(before);
      mark(row);
    },
  };
}
