// Light and dark: the system's choice first, the reader's afterwards. Colours come from the style sheet.

const root = document.documentElement;
const system = matchMedia('(prefers-color-scheme: dark)');
const listeners = new Set();

const isDark = () => (root.dataset.theme ? root.dataset.theme === 'dark' : system.matches);

const known = new Map();

/** A colour of the style sheet by its name without the dashes. */
export function colour(name) {
  if (!known.has(name)) known.set(name, getComputedStyle(root).getPropertyValue(`--${name}`).trim());
  return known.get(name);
}

export const onTheme = (listener) => listeners.add(listener);

function changed() {
  known.clear();
  listeners.forEach((listener) => listener());
}

export function setTheme(name) {
  root.dataset.theme = name === 'dark' ? 'dark' : 'light';
  changed();
}

export const toggleTheme = () => setTheme(isDark() ? 'light' : 'dark');

system.addEventListener('change', changed);

/** Stops of the scale of errors, small to large, and where between them a share of the largest stands. */
export function scale(stops = ['scale-0', 'scale-1', 'scale-2'].map(colour)) {
  const rgb = stops.map((text) => [1, 3, 5].map((at) => parseInt(text.slice(at, at + 2), 16) / 255));
  return (share, out, at) => {
    const place = Math.min(Math.max(share, 0), 1) * (rgb.length - 1);
    const low = Math.min(Math.floor(place), rgb.length - 2);
    for (let k = 0; k < 3; k += 1) out[at + k] = rgb[low][k] + (rgb[low + 1][k] - rgb[low][k]) * (place - low);
  };
}
