// Sliders, switches and buttons with their labels; every one works by keyboard.

import { h, newId } from './dom.js';

/** A slider: `show(value)` is its value in words, `on(value)` is told of changes. */
export function slider({ label, min, max, step, value, show, on, name }) {
  const id = newId('slider');
  const output = h('output', { htmlFor: id });
  const input = h('input', { type: 'range', id, min, max, step, name: name ?? id, oninput: () => update(true) });
  const update = (told) => {
    const text = show(Number(input.value));
    output.textContent = text;
    input.setAttribute('aria-valuetext', text);
    if (told) on(Number(input.value));
  };
  input.value = value;
  update(false);
  return {
    element: h('div', { class: 'slider' }, h('label', { htmlFor: id, text: label }), output, input),
    input,
    set(now) {
      if (Number(input.value) === now) return;
      input.value = now;
      update(false);
    },
    refresh: () => update(false),
  };
}

export function check({ label, value, on, name }) {
  const id = newId('check');
  const input = h('input', { type: 'checkbox', id, checked: value, name: name ?? id, onchange: () => on(input.checked) });
  return h('div', { class: 'check' }, input, h('label', { htmlFor: id, text: label }));
}

/** A row of choices of which one is taken. */
export function choice({ label, options, value, on, name }) {
  const group = newId('choice');
  const one = ([key, text]) => {
    const id = newId('option');
    const input = h('input', { type: 'radio', id, name: group, value: key, checked: key === value, onchange: () => on(key) });
    return h('span', { class: 'option' }, input, h('label', { htmlFor: id, text }));
  };
  return h('fieldset', { class: 'choice', 'data-name': name ?? group }, h('legend', { text: label }), options.map(one));
}

export function select({ label, options, value, on, name }) {
  const id = newId('select');
  const input = h('select', { id, name: name ?? id, onchange: () => on(input.value) }, options.map(([key, text]) => h('option', { value: key, text })));
  input.value = value;
  return h('div', { class: 'field' }, h('label', { htmlFor: id, text: label }), input);
}

export function search({ label, on, name, type = 'search', placeholder = '' }) {
  const id = newId('search');
  const input = h('input', { type, id, placeholder, name: name ?? id, autocomplete: 'off', spellcheck: false, oninput: () => on(input.value) });
  return h('div', { class: 'field' }, h('label', { htmlFor: id, text: label }), input);
}

export const button = (text, on, properties = {}) => h('button', { type: 'button', text, onclick: on, ...properties });
