// The page: reads the data that stands in it and shows what they are.

import { h } from './dom.js';
import { compensation } from './compensation.js';
import { diagnosis } from './diagnosis.js';
import { accuracy, closedLoop, comparison, fitted, simulation } from './results.js';
import { plain } from './plain.js';
import { header } from './layout.js';

const KINDS = {
  compensate: compensation, diagnose: diagnosis, simulate: simulation, fit: fitted, accuracy,
  'compare-measurements': comparison, 'closed-loop': closedLoop,
};

const page = JSON.parse(document.getElementById('data').textContent);
const show = KINDS[page.command] ?? plain;
const { kind, verdict, tone, sections } = show(page);
document.getElementById('page').replaceChildren(
  h('a', { class: 'skip', href: '#main', text: 'Skip to the contents' }),
  header({ title: page.title, kind, verdict, tone, version: page.version, sections }),
  h('main', { id: 'main', tabIndex: -1 }, sections),
);
