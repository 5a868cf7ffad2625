// Worlds, robots and logs of one's own: files and folders that are dropped on the page of a live run, or chosen.
import {element} from './dom.js';

const kLargest = 64 * 1024 * 1024;  // [bytes]
const kMost = 2000;  // Files.
const kWorlds = ['.world', '.world.xacro', '.sdf', '.sdf.xacro'];
const kRobots = ['.urdf', '.xacro'];
const kMaps = ['.yaml', '.yml'];
const kPictures = ['.pgm', '.png', '.bmp', '.jpg'];
const kLogs = ['.log', '.log.gz', '.carmen', '.carmen.gz', '.mcap'];
const kModel = /(^|\/)model[-_\d]*\.sdf$/;  // A part of Gazebo's worlds.

const ends = (endings) => (name) => endings.some((end) => name.toLowerCase().endsWith(end));

/** Those of `names` that are worlds: files of worlds, not of the models in them, if there is one. */
function worldsOf(names) {
  const all = names.filter(ends(kWorlds));
  const worlds = all.filter((name) => !kModel.test(name));
  return worlds.length > 0 ? worlds : all;
}

/**
 * What can be loaded of the files `names`, each as {file}: logs with their {map}, else worlds and robots; maps where there is
 * no other world. Beside a robot, YAML files without a picture are its settings.
 */
export function mainFiles(names) {
  const maps = names.filter(ends(kMaps));
  const logs = names.filter(ends(kLogs));
  if (logs.length > 0) return logs.map((file) => ({file, map: maps[0] ?? ''}));
  const robots = names.filter((name) => ends(kRobots)(name) && !ends(kWorlds)(name));
  const asMaps = robots.length > 0 && !names.some(ends(kPictures)) ? [] : maps;
  const worlds = worldsOf(names);
  const files = worlds.length === 0 && asMaps.length > 0 ? asMaps : [...worlds, ...robots];
  return files.map((file) => ({file}));
}

/** Why files [{name, file}] cannot be used, in one line; null if they can. */
export function refusalOf(files) {
  const large = files.find(({file}) => file.size > kLargest);
  if (large) return `${large.name} has more than 64 MiB.`;
  if (files.length > kMost) return `These are more than ${kMost} files.`;
  return mainFiles(files.map(({name}) => name)).length > 0 ? null
    : 'Drop a world (.yaml with its picture, .sdf, .world), a robot (.urdf, .xacro) or a log (.log, .log.gz, .mcap), with '
      + 'the files that it needs, or their folder.';
}

/** Sends files [{name, file}] to the server at `location`. Throws Error with its words if it refuses one. */
export async function bring(files, location) {
  for (const {name, file} of files) {
    const query = new URLSearchParams(location.search);
    query.set('name', name);
    const answer = await fetch(`/file?${query}`, {method: 'POST', body: file});
    if (!answer.ok) throw new Error(`${name}: ${(await answer.text()).trim()}`);
  }
}

/** The files below an entry of a drop, as [{name, file}]; hidden ones are left out. */
async function filesBelow(entry) {
  if (entry.name.startsWith('.')) return [];
  if (entry.isFile) {
    const file = await new Promise((resolve, reject) => entry.file(resolve, reject));
    return [{name: entry.fullPath.replace(/^\//, ''), file}];
  }
  const reader = entry.createReader();
  const files = [];
  for (;;) {  // It tells of a hundred at a time.
    const entries = await new Promise((resolve, reject) => reader.readEntries(resolve, reject));
    if (entries.length === 0 || files.length > kMost) return files;
    for (const each of entries) files.push(...await filesBelow(each));
  }
}

/** All that was dropped. */
async function filesOfDrop({items, files}) {
  const entries = [...items].map((item) => item.webkitGetAsEntry?.()).filter(Boolean);
  if (entries.length === 0) return filesOfList(files);
  return (await Promise.all(entries.map(filesBelow))).flat();
}

/** Those of an input: with their paths, if it chooses folders. */
function filesOfList(list) {
  return [...list].map((file) => ({name: file.webkitRelativePath || file.name, file}))
    .filter(({name}) => !name.split('/').some((part) => part.startsWith('.')));
}

/** Buttons that load one of several files. */
function choices(mains, load) {
  return [`${mains.length} could be loaded: `, ...mains.slice(0, 12).map((main) =>
    element('button', {type: 'button', click: () => load(main)}, main.file))];
}

/**
 * Takes files that are dropped on `place`, and those of buttons, which it returns. `load({file, map})`; `note(...parts)`: shows
 * texts and buttons.
 */
export function fileTools(place, signal, load, note) {
  const take = async (list) => {
    try {
      const files = await list;
      if (files.length === 0) return;
      const refusal = refusalOf(files);
      if (refusal) return note(refusal);
      await bring(files, window.location);
      const mains = mainFiles(files.map(({name}) => name));
      if (mains.length === 1) load(mains[0]);
      else note(...choices(mains, load));
    } catch (error) {
      note(error.message);
    }
  };
  const chooser = (text, title, more) => {
    const input = element('input', {type: 'file', multiple: true, hidden: true, ...more, change: () => take(filesOfList(input.files))});
    return [element('button', {type: 'button', title, click: () => input.click()}, text), input];
  };
  place.addEventListener('dragover', (event) => event.preventDefault(), {signal});
  place.addEventListener('drop', (event) => {
    event.preventDefault();
    take(filesOfDrop(event.dataTransfer));
  }, {signal});
  return [...chooser('Own world, robot or log…', 'Or drop the files on the page', {}),
    ...chooser('Folder…', 'A folder with a world or a robot and its meshes; or drop it on the page', {webkitdirectory: true})];
}
