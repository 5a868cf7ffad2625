// The keyboard: what each key does.

/** The action that a key asks for; null: none. Arrow keys with shift go further. */
export function actionOf({key, shiftKey, ctrlKey, metaKey, altKey}) {
  if (ctrlKey || metaKey || altKey) return null;
  switch (key) {
    case ' ': return ['toggle'];
    case 'k': return ['toggle'];
    case 'ArrowLeft': return shiftKey ? ['skip', -5] : ['step', -1];
    case 'ArrowRight': return shiftKey ? ['skip', 5] : ['step', 1];
    case 'ArrowUp': return ['jump', -1];
    case 'ArrowDown': return ['jump', 1];
    case 'Home': return ['seek', -Infinity];
    case 'End': return ['seek', Infinity];
    case '+': case '=': return ['zoom', 1.25];
    case '-': case '_': return ['zoom', 0.8];
    case '0': return ['fit'];
    case ',': case '<': return ['faster', -1];
    case '.': case '>': return ['faster', 1];
    case 'f': return ['follow'];
    case '3': return ['toggle3d'];
    case 't': return ['top'];
    default: return null;
  }
}

/** Elements that have a use for the key themselves. */
export function ownsKey(element, key) {
  const tag = element?.tagName;
  if (tag === 'SELECT' || tag === 'TEXTAREA') return true;
  if (tag === 'INPUT') return element.type === 'checkbox' ? key === ' ' : element.type !== 'range';
  return (tag === 'BUTTON' || tag === 'A' || tag === 'SUMMARY') && (key === ' ' || key === 'Enter');
}

export const kHelp = [
  ['space', 'play, pause'], ['← →', 'a scan back, on; with shift 5 s'], ['↑ ↓', 'event before, after'],
  ['home end', 'first, last scan'], [', .', 'slower, faster'], ['+ −', 'zoom the map'], ['0', 'whole map'],
  ['f', 'follow the robot'], ['3', 'map or 3-D view'], ['t', '3-D: from above'], ['← ↑ → ↓', '3-D: turn; with shift: move'],
];
