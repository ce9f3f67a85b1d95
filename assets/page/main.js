// The page: reads the data that stands in it and shows what they are.

import { h } from './dom.js';
import { compensation } from './compensation.js';
import { diagnosis } from './diagnosis.js';
import { fitted } from './fit.js';
import { accuracy, closedLoop, comparison } from './results.js';
import { simulation } from './simulation.js';
import { plain } from './plain.js';
import { watched } from './watch.js';
import { header } from './layout.js';

const KINDS = {
  compensate: compensation, diagnose: diagnosis, simulate: simulation, fit: fitted, accuracy,
  'compare-measurements': comparison, 'closed-loop': closedLoop, 'link watch': watched,
};

const whole = JSON.parse(document.getElementById('data').textContent);
// Of several tasks one is shown: the address says which, so that a link, a bookmark and the way back know it.
const tasks = whole.view.tasks ? whole.data.tasks : null;
const which = tasks ? Math.min(Math.max(Number(new URLSearchParams(location.search).get('task') ?? 1) - 1, 0), tasks.length - 1) || 0 : 0;
const page = tasks ? { ...whole, data: tasks[which], view: whole.view.tasks[which] } : whole;
const show = KINDS[page.command] ?? plain;
const { kind, verdict, tone, sections } = show(page);
const main = h('main', { id: 'main', tabIndex: -1 });
const head = header({ title: page.title, kind, verdict, tone, version: page.version, tasks: tasks?.map((one) => one.task), which });
document.getElementById('page').replaceChildren(h('a', { class: 'skip', href: '#main', text: 'Skip to the contents' }), head.element, main);

/** One section after the other, each when the one before it is seen: what comes first is there at once. */
function add(rest) {
  const [make, ...later] = rest;
  if (!make) {
    document.documentElement.dataset.whole = 'yes';
    dispatchEvent(new Event('page-whole'));
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
