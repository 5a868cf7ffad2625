// Light, dark, or as the system has it.
import {element} from './dom.js';

const kKey = 'castaway-theme';
const kThemes = ['auto', 'light', 'dark'];
const kSymbols = {auto: '◐', light: '☀', dark: '☾'};

/** Pages opened from disk may have no storage. */
function stored() {
  try {
    return localStorage.getItem(kKey);
  } catch {
    return null;
  }
}

function store(theme) {
  try {
    localStorage.setItem(kKey, theme);
  } catch {
    // The choice then holds for this page only.
  }
}

/** Puts the switch into `place` and calls `changed` whenever the colours change. */
export function addThemeSwitch(place, changed) {
  let theme = kThemes.includes(stored()) ? stored() : 'auto';
  const button = element('button', {type: 'button', class: 'theme', click: () => {
    theme = kThemes[(kThemes.indexOf(theme) + 1) % kThemes.length];
    store(theme);
    apply();
  }});
  function apply() {
    if (theme === 'auto') delete document.documentElement.dataset.theme;
    else document.documentElement.dataset.theme = theme;
    button.textContent = `${kSymbols[theme]} ${theme}`;
    button.setAttribute('aria-label', `Colours: ${theme}. Change`);
    changed();
  }
  place.append(button);
  matchMedia('(prefers-color-scheme: dark)').addEventListener('change', changed);
  apply();
}
