// Worlds, robots and logs of one's own: files that are dropped on the page of a live run, or chosen.
import {element} from './dom.js';

const kLargest = 64 * 1024 * 1024;  // [bytes]
const kWorlds = ['.sdf', '.world', '.sdf.xacro', '.world.xacro'];
const kRobots = ['.urdf', '.xacro'];
const kMaps = ['.yaml', '.yml'];
const kLogs = ['.log', '.log.gz', '.carmen', '.carmen.gz', '.mcap'];

/** What to load of the files `names`: {file}, a world, a robot or a map; a log with its {map}; null: nothing. */
export function mainFile(names) {
  const ending = (endings) => names.find((name) => endings.some((end) => name.toLowerCase().endsWith(end)));
  const log = ending(kLogs);
  if (log) return {file: log, map: ending(kMaps) ?? ''};
  const file = ending(kWorlds) ?? ending(kMaps) ?? ending(kRobots);
  return file ? {file} : null;
}

/** Why files cannot be used, in one line; null if they can. */
export function refusalOf(files) {
  const large = files.find((file) => file.size > kLargest);
  if (large) return `${large.name} has more than 64 MiB.`;
  return mainFile(files.map((file) => file.name)) ? null
    : 'Drop a world (.yaml with its picture, .sdf, .world), a robot (.urdf, .xacro) or a log (.log, .log.gz, .mcap), with '
      + 'the files that it needs.';
}

/** Sends files to the server at `location`. Throws Error with its words if it refuses one. */
export async function bring(files, location) {
  for (const file of files) {
    const query = new URLSearchParams(location.search);
    query.set('name', file.name);
    const answer = await fetch(`/file?${query}`, {method: 'POST', body: file});
    if (!answer.ok) throw new Error((await answer.text()).trim());
  }
}

/** Takes files that are dropped on `place`, and those of a button, which it returns. `load({file, map})`, `note(text)`. */
export function fileTools(place, signal, load, note) {
  const take = async (list) => {
    const files = [...list];
    if (files.length === 0) return;
    const refusal = refusalOf(files);
    if (refusal) return note(refusal);
    try {
      await bring(files, window.location);
      load(mainFile(files.map((file) => file.name)));
    } catch (error) {
      note(error.message);
    }
  };
  const input = element('input', {type: 'file', multiple: true, hidden: true, change: () => take(input.files)});
  place.addEventListener('dragover', (event) => event.preventDefault(), {signal});
  place.addEventListener('drop', (event) => {
    event.preventDefault();
    take(event.dataTransfer.files);
  }, {signal});
  const button = element('button', {type: 'button', title: 'Or drop the files on the page', click: () => input.click()},
    'Own world, robot or log…');
  return [button, input];
}
