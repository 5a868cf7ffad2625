// Memory of a process and of those that it has started, from /proc. [MiB]
import {readdirSync, readFileSync} from 'node:fs';

const fieldsOf = (pid) => readFileSync(`/proc/${pid}/stat`, 'utf8').replace(/^.*\) /, '').split(' ');

/** A number of kB in a file of /proc, as MiB; 0 if the process has ended. */
function mebibytes(path, name) {
  try {
    return Number(readFileSync(path, 'utf8').match(new RegExp(`^${name}:\\s+(\\d+) kB`, 'm'))?.[1] ?? 0) / 1024;
  } catch {
    return 0;
  }
}

/** Processes below `ancestor`: {pid, ticks of CPU}. */
function descendants(ancestor) {
  const all = readdirSync('/proc').filter((name) => /^\d+$/.test(name)).flatMap((pid) => {
    try {
      const fields = fieldsOf(pid);
      return [{pid: Number(pid), parent: Number(fields[1]), ticks: Number(fields[11]) + Number(fields[12])}];
    } catch {
      return [];  // It has ended.
    }
  });
  const found = new Set([ancestor]);
  for (let before = 0; before < found.size;) {
    before = found.size;
    for (const {pid, parent} of all) if (found.has(parent)) found.add(pid);
  }
  found.delete(ancestor);
  return all.filter(({pid}) => found.has(pid));
}

/** Of castaway live: resident size of the server and of the run, and what the run and its copies that wait share or
 * have of their own (the sum of their proportional sizes). The run is the process that has used the most CPU. */
export function memoryOf(server) {
  const below = descendants(server);
  const run = below.reduce((most, each) => (each.ticks > most.ticks ? each : most));
  const resident = (pid) => mebibytes(`/proc/${pid}/status`, 'VmRSS');
  return {server: resident(server), run: resident(run.pid),
    copies: below.reduce((sum, {pid}) => sum + mebibytes(`/proc/${pid}/smaps_rollup`, 'Pss'), 0)};
}
