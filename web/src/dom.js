// Elements of the page, made by hand.

/** An element with attributes (functions: listeners of that event) and children. */
export function element(tag, attributes = {}, ...children) {
  const made = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) {
    if (typeof value === 'function') made.addEventListener(name, value);
    else if (value !== null && value !== false) made.setAttribute(name, value === true ? '' : value);
  }
  made.append(...children.filter((child) => child !== null));
  return made;
}

/** Shows or hides an element. If it had the focus, `heir` gets it. */
export function reveal(it, shown, heir) {
  if (!shown && document.activeElement === it) heir.focus();
  it.hidden = !shown;
}

/** "83.1" seconds as "83.1 s"; from 100 s on also in minutes: "1:43.1". */
export function clockText(seconds) {
  if (seconds < 100) return `${seconds.toFixed(1)} s`;
  const minutes = Math.floor(seconds / 60);
  return `${minutes}:${(seconds - 60 * minutes).toFixed(1).padStart(4, '0')}`;
}

/** Three digits and the unit; a dash for nothing. */
export function readable(value, unit) {
  if (value === null || !Number.isFinite(value)) return '–';
  const size = Math.abs(value);
  const digits = size >= 100 ? 0 : size >= 10 ? 1 : size >= 1 ? 2 : 3;
  return `${value.toFixed(digits)} ${unit}`;
}
