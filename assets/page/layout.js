// What every page has: head, sections, messages, figures, record with lines to sign.

import { NONE, h, plural } from './dom.js';
import { button } from './controls.js';
import { toggleTheme } from './theme.js';

/** Head of the page with links to its sections. */
export function header({ title, kind, verdict, tone, version, tasks, which }) {
  const nav = h('nav', { 'aria-label': 'Sections' });
  const element = h('header', { class: 'top' },
    h('div', { class: 'brand' },
      h('p', { class: 'kind' }, h('span', { class: 'word', text: 'driftpost' }), ` ${version} · ${kind}`),
      h('h1', { title, text: title }),
      tasks && h('p', { class: 'tasks' }, tasks.map((name, i) => h('a', { href: `?task=${i + 1}`, text: name, 'aria-current': i === which && 'page' }))),
      verdict && h('p', { class: `verdict ${tone}`, text: verdict })),
    h('div', { class: 'tools' },
      button('Light / dark', toggleTheme, { class: 'small', name: 'theme' }),
      button('Print', () => print(), { class: 'small' })),
    nav);
  return { element, link: (section) => nav.append(h('a', { href: `#${section.id}`, text: section.dataset.short })) };
}

/** A section with its heading; `short` stands in the head's links. */
export function section(id, title, short, ...content) {
  return h('section', { id, 'aria-labelledby': `${id}-title`, 'data-short': short }, h('h2', { id: `${id}-title`, text: title }), ...content);
}

/** A figure with what it means. */
export const figure = (label, value, unit, note, tone = '') => h('div', { class: `figure ${tone}` },
  h('dt', { text: label }), h('dd', {}, h('span', { class: 'value', text: value }), unit && value !== NONE && h('span', { class: 'unit', text: ` ${unit}` }), note && h('span', { class: 'note', text: note })));

export const figures = (...all) => h('dl', { class: 'figures' }, all);

const SHOWN = 8;
const SENTENCES = 12;

/** The last part of a path. */
export const nameOfFile = (path) => path.split('/').pop();

/** Refusals and warnings, gathered by code; a long list opens. */
export function messages(list, tone) {
  const one = (message) => h('li', { class: `message ${tone}` },
    h('span', { class: 'code', text: message.code }), h('span', { class: 'said', text: message.message }),
    message.file && h('span', { class: 'place', title: message.file, text: `${nameOfFile(message.file)}${message.line ? `:${message.line}` : ''}` }),
    message.help && h('span', { class: 'help', text: message.help }));
  const first = list.slice(0, SHOWN).map(one);
  const rest = list.slice(SHOWN);
  return [
    h('ul', { class: 'messages' }, first),
    rest.length > 0 && later(`${plural(rest.length, 'more message')}`, () => h('ul', { class: 'messages' }, rest.slice(0, 500).map(one), rest.length > 500 && h('li', { class: 'message', text: `and ${rest.length - 500} more: see the JSON` })), { printed: true }),
  ];
}

/** Sentences of a report, in its order; a long list opens. */
export function notes(list) {
  const items = (some) => h('ul', { class: 'notes' }, some.map((text) => h('li', { text })));
  if (!list || list.length === 0) return null;
  return [items(list.slice(0, SENTENCES)), list.length > SENTENCES && later(plural(list.length - SENTENCES, 'more sentence'), () => items(list.slice(SENTENCES)), { printed: true })];
}

/** A part that is made when it is opened; `printed` is open on paper. */
export function later(summary, make, { printed: isPrinted = false } = {}) {
  const details = h('details', {}, h('summary', { text: summary }));
  const fill = () => { if (details.children.length === 1) details.append(...[make()].flat()); };
  details.addEventListener('toggle', () => { if (details.open) fill(); });
  if (isPrinted) {
    let wasOpen = false;
    addEventListener('beforeprint', () => { wasOpen = details.open; fill(); details.open = true; });
    addEventListener('afterprint', () => { details.open = wasOpen; });
  }
  return details;
}

/** The report as a terminal has it. */
export const printed = (view) => view.text && later('The report as printed', () => h('pre', { class: 'report', tabIndex: 0, text: view.text }));

/** Names and values. */
export const facts = (pairs) => h('dl', { class: 'facts' }, pairs.map(([name, value]) => h('div', {}, h('dt', { text: name }), h('dd', { text: value }))));

/** What was used, with hashes, and lines to sign in print. */
export function record(pairs, version) {
  const line = (role) => h('div', { class: 'sign' }, h('span', { class: 'line' }), h('span', { text: `${role}: name, date, signature` }));
  return section('record', 'Record', 'Record',
    facts([...pairs, ['made with', `driftpost ${version}`]]),
    h('div', { class: 'signatures' }, line('Made by'), line('Reviewed by'), line('Released by')));
}
