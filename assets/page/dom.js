// Elements, numbers and text. Text of a program goes into text nodes alone.

/** An element with properties, listeners (on...) and children. */
export function h(tag, properties = {}, ...children) {
  const element = document.createElement(tag);
  set(element, properties);
  element.append(...children.flat(Infinity).filter((child) => child !== null && child !== undefined && child !== false));
  return element;
}

const SVG = 'http://www.w3.org/2000/svg';

/** An SVG element with attributes and children. */
export function svg(tag, attributes = {}, ...children) {
  const element = document.createElementNS(SVG, tag);
  for (const [name, value] of Object.entries(attributes)) element.setAttribute(name, value);
  element.append(...children.flat(Infinity));
  return element;
}

function set(element, properties) {
  for (const [name, value] of Object.entries(properties)) {
    if (value === undefined || value === null || value === false) continue;
    if (name.startsWith('on')) element.addEventListener(name.slice(2), value);
    else if (name === 'text') element.textContent = value;
    else if (name === 'class') element.className = value;
    else if (name in element && !name.startsWith('aria') && name !== 'list') element[name] = value;
    else element.setAttribute(name, value === true ? '' : value);
  }
}

let last = 0;

/** An id that no other element of the page has. */
export const newId = (name) => `${name}-${(last += 1)}`;

/** What stands where there is no number. */
export const NONE = '–';

/** A length in mm with so many decimals; a dash where there is none. */
export const mm = (value, decimals = 4) => (Number.isFinite(value) ? value.toFixed(decimals) : NONE);

export const deg = (value, decimals = 3) => (Number.isFinite(value) ? value.toFixed(decimals) : NONE);

/** 12345 as 12,345. */
export const count = (value) => value.toLocaleString('en-US');

export const plural = (n, word) => `${count(n)} ${word}${n === 1 ? '' : 's'}`;

/** A number of any size as a person reads it. */
export function number(value) {
  if (value === null || value === undefined || !Number.isFinite(value)) return NONE;
  const size = Math.abs(value);
  if (value !== 0 && (size < 1e-3 || size >= 1e6)) return value.toExponential(2);
  return String(Number(value.toPrecision(5)));
}

/** A size with its standard uncertainty to two significant digits, both to the same place. */
export function measured(value, sigma) {
  if (!Number.isFinite(sigma) || sigma <= 0 || !Number.isFinite(value)) return `${number(value)} ± ${number(sigma)}`;
  const place = (one) => Math.floor(Math.log10(Math.abs(one)));
  const size = Math.abs(value);
  const exponent = value !== 0 && (size < 1e-3 || size >= 1e6) ? place(value) : 0;
  const decimals = Math.min(Math.max(exponent - place(sigma) + 1, 0), 9);
  const to = (one) => `${(one / 10 ** exponent).toFixed(decimals)}${exponent === 0 ? '' : `e${exponent}`}`;
  return `${to(value)} ± ${to(sigma)}`;
}

/** Calls `work` once before the next picture, however often it is asked for. */
export function oncePerFrame(work) {
  let waiting = false;
  return () => {
    if (waiting) return;
    waiting = true;
    requestAnimationFrame(() => {
      waiting = false;
      work();
    });
  };
}

const whenIdle = globalThis.requestIdleCallback ?? ((work) => setTimeout(() => work({ timeRemaining: () => 5 }), 100));

/** Does `work(i)` for each i below `n` while nothing else is asked of the page. */
export function beforehand(n, work) {
  let i = 0;
  const go = (deadline) => {
    for (; i < n && deadline.timeRemaining() > 2; i += 1) work(i);
    if (i < n) whenIdle(go);
  };
  whenIdle(go);
}

/** Values that listeners follow: `set` tells those who asked for a changed name. */
export function store(values) {
  const listeners = [];
  return {
    ...values,
    set(changed) {
      const names = Object.keys(changed).filter((name) => this[name] !== changed[name]);
      if (names.length === 0) return;
      Object.assign(this, changed);
      for (const [wanted, listener] of listeners) if (wanted.some((name) => names.includes(name))) listener(this);
    },
    on(names, listener) {
      listeners.push([names.split(' '), listener]);
    },
  };
}
