// What is measured inside the page of a live run: its redraws, its speed, the time from a hand to the picture.
/* global window, document, CanvasRenderingContext2D, addEventListener, requestAnimationFrame */

/** Runs in the page before its own scripts; leaves `window.probe`. */
function install() {
  const probe = {redraws: 0, frame: -1, status: [], waiting: {}, taken: {ghost: [], kidnap: []}};
  window.probe = probe;
  const canvas = CanvasRenderingContext2D.prototype;
  const isMap = (context) => context.canvas.classList?.contains('map');

  /** `what` is in the picture that is being drawn: how long it takes from the hand until that is handed over. */
  function drawn(what, since) {
    const {port1, port2} = new MessageChannel();
    port1.onmessage = () => probe.taken[what].push(performance.now() - since);
    port2.postMessage(0);
  }

  /** When the hand moved that `what` waits for; undefined: it waits for none. */
  function take(what) {
    const since = probe.waiting[what];
    delete probe.waiting[what];
    return since;
  }

  const {drawImage, stroke, setLineDash} = canvas;
  canvas.drawImage = function (...given) {
    const now = document.timeline.currentTime;
    if (isMap(this) && now !== probe.frame) {
      probe.frame = now;
      ++probe.redraws;
    }
    return drawImage.apply(this, given);
  };
  canvas.setLineDash = function (dash) {
    if (probe.waiting.ghost && String(dash) === '5,4' && isMap(this)) {  // Of the ghost: see live_hands.js.
      const since = take('ghost');
      requestAnimationFrame(() => drawn('ghost', since));
    }
    return setLineDash.call(this, dash);
  };
  canvas.stroke = function (...given) {
    const isKidnap = probe.waiting.kidnap && String(this.getLineDash()) === '6,5' && isMap(this);  // See layers.js.
    stroke.apply(this, given);
    if (isKidnap) drawn('kidnap', take('kidnap'));
  };
  addEventListener('pointermove', ({timeStamp, buttons}) => {
    if (buttons) probe.waiting.ghost = timeStamp;
  }, true);
  addEventListener('click', ({timeStamp, target}) => {
    if (target.textContent === 'Anywhere') probe.waiting.kidnap = timeStamp;
  }, true);

  window.WebSocket = class extends WebSocket {
    constructor(...given) {
      super(...given);
      this.addEventListener('message', ({data}) => {
        if (typeof data !== 'string' || data.length > 1000) return;
        const {said, now_s: now, playing} = JSON.parse(data);
        if (said === 'status' && playing) probe.status.push({wall: performance.now(), now});
      });
    }
  };
}

export const kProbe = `(${install})()`;

/** In the page: the rows of all scans that the server kept, asked for as a page that opens anew. */
export const kHistory = `new Promise((resolve) => {
  const socket = new WebSocket('ws://' + location.host + '/live' + location.search);
  socket.addEventListener('message', ({data}) => {
    if (typeof data !== 'string' || !data.startsWith('{"said":"history"')) return;
    socket.close();
    resolve(JSON.parse(data).scans.map(([time, , , answers]) => [time, ...answers.map(({answer}) => answer !== null)]));
  });
})`;
