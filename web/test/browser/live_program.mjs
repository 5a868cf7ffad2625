// castaway live as a child process.
import {spawn} from 'node:child_process';
import {mkdtempSync, rmSync} from 'node:fs';
import {tmpdir} from 'node:os';
import {join} from 'node:path';

/** Starts `castaway live ARGS` on a free port. Resolves to the process and the address that it prints. */
export function startLive(program, args) {
  const folder = mkdtempSync(join(tmpdir(), 'castaway-live-'));  // For its reports, and files that are dropped.
  const server = spawn(program, ['live', '--port', '0', ...args], {cwd: folder, stdio: ['ignore', 'pipe', 'inherit']});
  server.on('exit', () => rmSync(folder, {recursive: true, force: true}));
  return new Promise((resolve, reject) => {
    let text = '';
    server.stdout.on('data', (data) => {
      text += data;
      if (text.includes('\n')) resolve({server, url: text.trim()});
    });
    server.on('exit', (code) => reject(new Error(`castaway live ended with ${code}`)));
  });
}
