// castaway live as a child process.
import {spawn} from 'node:child_process';

/** Starts `castaway live ARGS` on a free port. Resolves to the process and the address that it prints. */
export function startLive(program, args) {
  const server = spawn(program, ['live', '--port', '0', ...args], {stdio: ['ignore', 'pipe', 'inherit']});
  return new Promise((resolve, reject) => {
    let text = '';
    server.stdout.on('data', (data) => {
      text += data;
      if (text.includes('\n')) resolve({server, url: text.trim()});
    });
    server.on('exit', (code) => reject(new Error(`castaway live ended with ${code}`)));
  });
}
