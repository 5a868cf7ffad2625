// The large button over the map that starts a live run. It is gone once the run has been played.
import {element, reveal} from './dom.js';
import {icon} from './icons.js';

export class StartButton {
  /** `start()`: plays the run. `heir`: gets the focus when the button goes. */
  constructor(start, heir) {
    this.heir = heir;
    this.played = false;
    this.button = element('button', {type: 'button', class: 'start', 'aria-label': 'Play the run', hidden: true, click: start},
      icon('play'), 'Play');
  }

  /** `begun`: the run has come further than its first scan. */
  show(playing, begun) {
    this.played ||= playing || begun;
    reveal(this.button, !this.played, this.heir);
  }
}
