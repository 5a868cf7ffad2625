// Starts the page of a live run.
import './player.css';
import './live.css';
import './view3d/view3d.css';
import {element} from './dom.js';
import {LiveConnection, streamUrl} from './live_connection.js';
import {LiveView} from './live_view.js';
import {addThemeSwitch} from './theme.js';

const place = document.getElementById('castaway-live');
const line = element('p', {role: 'status', class: 'line'}, 'Connecting…');
place.before(line);
document.body.classList.add('live');
let view = null;
let fresh = true;  // The line is new: all is told again.
const early = new Map();  // What a view must know that is told before there is one.
addThemeSwitch(document.getElementById('castaway-theme-place') ?? document.body, () => view?.recolor());

const connection = new LiveConnection(streamUrl(location), {
  said: (message) => {
    if (['hands', 'status'].includes(message.said)) early.set(message.said, message);
    if (message.said === 'hello') {
      if (view && message.undone && !fresh) return;  // The run went back: what came before stays.
      fresh = false;
      view?.end();
      view = new LiveView(place, message.run, (command) => connection.send(command));
      document.querySelector('h1').textContent = message.run.scenario;
      for (const told of early.values()) view.said(told);
      place.dataset.ready = 'true';
    } else {
      view?.said(message);
    }
  },
  frame: (frame) => view?.frame(frame),
  open: (isOpen) => {
    line.hidden = isOpen;
    fresh = true;
    line.textContent = 'The line to the run is broken; it is tried again.';
  },
});
