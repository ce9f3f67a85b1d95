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
const main = h('main', { id: 'main', tabIndex: -1 });
const head = header({ title: page.title, kind, verdict, tone, version: page.version });
document.getElementById('page').replaceChildren(h('a', { class: 'skip', href: '#main', text: 'Skip to the contents' }), head.element, main);

/** One section after the other, each when the one before it is seen: what comes first is there at once. */
function add(rest) {
  const [make, ...later] = rest;
  if (!make) {
    document.documentElement.dataset.whole = 'yes';
    return;
  }
  const section = make();
  if (section) {
    main.append(section);
    head.link(section);
  }
  const next = () => add(later);
  // a page that nobody looks at draws no frames
  if (document.hidden) setTimeout(next);
  else requestAnimationFrame(() => setTimeout(next));
}

add(sections);
