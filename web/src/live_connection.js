// The line to the run: commands go out, messages and frames come in. It is opened again when it breaks.
import {readFrame} from './live_frame.js';

const kAgain = [500, 1000, 2000, 5000];  // [ms] Between tries.

export class LiveConnection {
  /** `said(message)`, `frame(frame)`, `open(isOpen)`: called as they come. */
  constructor(url, {said, frame, open}) {
    this.url = url;
    this.handlers = {said, frame, open};
    this.tries = 0;
    this.connect();
  }

  connect() {
    this.socket = new WebSocket(this.url);
    this.socket.binaryType = 'arraybuffer';
    this.socket.addEventListener('open', () => {
      this.tries = 0;
      this.handlers.open(true);
    });
    this.socket.addEventListener('message', ({data}) => {
      if (typeof data === 'string') this.handlers.said(JSON.parse(data));
      else this.handlers.frame(readFrame(data));
    });
    this.socket.addEventListener('close', () => {
      this.handlers.open(false);
      setTimeout(() => this.connect(), kAgain[Math.min(this.tries++, kAgain.length - 1)]);
    });
  }

  /** Sends a command; false if the line is broken. */
  send(command) {
    if (this.socket.readyState !== WebSocket.OPEN) return false;
    this.socket.send(JSON.stringify(command));
    return true;
  }
}

/** Where the stream of the page at `location` is. */
export function streamUrl({protocol, host, search}) {
  return `${protocol === 'https:' ? 'wss' : 'ws'}://${host}/live${search}`;
}
