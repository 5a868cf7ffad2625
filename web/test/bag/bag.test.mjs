// Bags of real runs, read by packages that are not ours: every message of every topic must be what our own reader makes
// of it. CASTAWAY_PROGRAM: the program; CASTAWAY_MODULES: folder with the packages of web/package.json.
import assert from 'node:assert/strict';
import {execFileSync} from 'node:child_process';
import {mkdtempSync, readFileSync, readdirSync, rmSync, writeFileSync} from 'node:fs';
import {createRequire} from 'node:module';
import {tmpdir} from 'node:os';
import {join} from 'node:path';
import {after, test} from 'node:test';

const require = createRequire(join(process.env.CASTAWAY_MODULES, 'package.json'));
const {McapIndexedReader, McapStreamReader, McapWriter} = require('@mcap/core');
const {parse} = require('@foxglove/rosmsg');
const {MessageReader, MessageWriter} = require('@foxglove/rosmsg2-serialization');
const {crc32} = require('@foxglove/crc');
const fzstd = require('fzstd');
const lz4 = require('lz4js');

const folder = mkdtempSync(join(tmpdir(), 'castaway-bag-'));
after(() => rmSync(folder, {recursive: true}));

const decompressHandlers = {
  zstd: (bytes, size) => fzstd.decompress(bytes, new Uint8Array(Number(size))),
  lz4: (bytes, size) => lz4.decompress(bytes, Number(size)),
};

function castaway(...words) {
  return execFileSync(process.env.CASTAWAY_PROGRAM, words, {encoding: 'utf8', maxBuffer: 1 << 30, stdio: 'pipe'});
}

/** A short run with people, a kidnap after so many seconds and two localizers; the bytes of its bag. */
function bagOf(compression, kidnapAt = 1) {
  const run = join(folder, compression);
  const sets = {
    'people.count': 3, 'events.0.kidnap.at_s': kidnapAt, 'outputs.snapshots': false, 'outputs.report': false,
    'outputs.bag.compression': compression, 'outputs.bag.particles': true,
    'outputs.bag.clouds': compression !== 'none',
  };
  castaway('run', '--duration', '4', '--seed', '5', '--out', run,
           ...Object.entries(sets).flatMap(([key, value]) => ['--set', `${key}=${value}`]));
  const [name] = readdirSync(join(run, 'bag')).filter((file) => file.endsWith('.mcap'));
  return {run, bytes: readFileSync(join(run, 'bag', name))};
}

/** As `castaway bag --messages` writes values. */
function plain(value) {
  if (typeof value === 'number') {
    if (Number.isNaN(value)) return 'nan';
    if (!Number.isFinite(value)) return value > 0 ? 'inf' : '-inf';
    return value === 0 ? 0 : value;
  }
  if (ArrayBuffer.isView(value) || Array.isArray(value)) return Array.from(value, plain);
  if (value !== null && typeof value === 'object') {
    return Object.fromEntries(Object.entries(value).map(([key, inner]) => [key, plain(inner)]));
  }
  return value;
}

const readers = new Map();
function decode(schema, data) {
  if (!readers.has(schema.name)) {
    const definition = parse(new TextDecoder().decode(schema.data), {ros2: true});
    readers.set(schema.name, new MessageReader(definition));
  }
  return plain(readers.get(schema.name).readMessage(data));
}

/** Messages by topic, as our own reader sees them. */
function oursByTopic(run) {
  const topics = {};
  for (const line of castaway('bag', run, '--messages').trimEnd().split('\n')) {
    const {topic, log_time_ns: time, message} = JSON.parse(line);
    assert.ok(message, `${topic} is decoded`);
    (topics[topic] ??= []).push({time, message: plain(message)});
  }
  return topics;
}

function compare(theirs, ours) {
  assert.deepEqual(Object.keys(theirs).sort(), Object.keys(ours).sort());
  for (const topic of Object.keys(ours)) {
    assert.equal(theirs[topic].length, ours[topic].length, topic);
    for (let i = 0; i < ours[topic].length; ++i) assert.deepEqual(theirs[topic][i], ours[topic][i], `${topic} ${i}`);
  }
}

async function readByIndex(bytes) {
  const readable = {
    size: async () => BigInt(bytes.length),
    read: async (offset, size) => bytes.subarray(Number(offset), Number(offset + size)),
  };
  const reader = await McapIndexedReader.Initialize({readable, decompressHandlers});
  const topics = {};
  for await (const message of reader.readMessages({validateCrcs: true})) {
    const channel = reader.channelsById.get(message.channelId);
    const schema = reader.schemasById.get(channel.schemaId);
    (topics[channel.topic] ??= []).push({time: Number(message.logTime), message: decode(schema, message.data)});
  }
  return {reader, topics};
}

function readAsStream(bytes) {
  const reader = new McapStreamReader({decompressHandlers, validateCrcs: true});
  reader.append(bytes);
  const schemas = new Map();
  const channels = new Map();
  const topics = {};
  const records = [];
  for (let record; (record = reader.nextRecord());) {
    records.push(record.type);
    if (record.type === 'Schema') schemas.set(record.id, record);
    if (record.type === 'Channel') channels.set(record.id, record);
    if (record.type === 'DataEnd') checkDataEnd(bytes, record);
    if (record.type !== 'Message') continue;
    const channel = channels.get(record.channelId);
    const schema = schemas.get(channel.schemaId);
    (topics[channel.topic] ??= []).push({time: Number(record.logTime), message: decode(schema, record.data)});
  }
  assert.ok(reader.done());
  return {topics, records};
}

function checkDataEnd(bytes, {dataSectionCrc}) {
  const summaryStart = Number(new DataView(bytes.buffer, bytes.byteOffset).getBigUint64(bytes.length - 28, true));
  assert.equal(crc32(bytes.subarray(0, summaryStart - 13)), dataSectionCrc);
}

for (const compression of ['zstd', 'lz4', 'none']) {
  test(`a bag with ${compression} is read alike by index, as a stream and by us`, async () => {
    const {run, bytes} = bagOf(compression);
    const ours = oursByTopic(run);
    for (const topic of ['/scan', '/odom', '/tf', '/tf_static', '/map', '/people', '/events', '/scan_labels',
                         '/mh_amcl/amcl_pose', '/mh_amcl/particlecloud', '/mh_amcl/hypotheses', '/ground_truth/odom']) {
      assert.ok(ours[topic]?.length > 0, `${topic} is there`);
    }
    const {reader, topics} = await readByIndex(bytes);
    compare(topics, ours);
    const stream = readAsStream(bytes);
    compare(stream.topics, ours);

    const counts = Object.values(ours).map((messages) => messages.length);
    assert.equal(reader.header.profile, 'ros2');
    assert.equal(Number(reader.statistics.messageCount), counts.reduce((a, b) => a + b));
    assert.equal(reader.statistics.chunkCount, reader.chunkIndexes.length);
    assert.ok(reader.chunkIndexes.every((chunk) => chunk.compression === (compression === 'none' ? '' : compression)));
    assert.deepEqual(reader.attachmentIndexes.map(({name}) => name),
                     ['scenario.yaml', 'map.yaml', 'map.pgm', 'waffle.urdf']);
    assert.deepEqual(reader.metadataIndexes.map(({name}) => name), ['run', 'labels']);
  });
}

/** Points of a cloud of floats: x, y, z, intensity. */
function pointsOf(cloud) {
  assert.deepEqual(cloud.fields.map(({name, offset, datatype, count}) => [name, offset, datatype, count]),
                   ['x', 'y', 'z', 'intensity'].map((name, index) => [name, 4 * index, 7, 1]));
  assert.equal(cloud.data.length, cloud.width * cloud.point_step);
  const view = new DataView(Uint8Array.from(cloud.data).buffer);
  return Array.from({length: cloud.width}, (_, i) => [0, 4, 8, 12].map((at) => view.getFloat32(16 * i + at, true)));
}

test('clouds hold the returns of the scans and the particles', async () => {
  const {topics} = await readByIndex(bagOf('lz4').bytes);
  let returns = 0;
  for (const [i, {message: scan}] of topics['/scan'].entries()) {
    const {header} = topics['/scan_points'][i].message;
    assert.deepEqual(header, scan.header);
    const points = pointsOf(topics['/scan_points'][i].message);
    const ends = scan.ranges.flatMap((range, beam) => {
      const angle = scan.angle_min + beam * scan.angle_increment;
      return typeof range === 'number' ? [[range * Math.cos(angle), range * Math.sin(angle)]] : [];
    });
    assert.equal(points.length, ends.length);
    ends.forEach(([x, y], at) => assert.ok(Math.hypot(points[at][0] - x, points[at][1] - y, points[at][2]) < 1e-4));
    returns += ends.length;
  }
  assert.ok(returns > 1000);
  for (const [i, {message: {header, poses}}] of topics['/amcl/particlecloud'].entries()) {
    const cloud = topics['/amcl/particle_points'][i].message;
    assert.deepEqual(cloud.header, header);
    assert.ok(poses.length > 100);
    const expected = poses.map(({position: {x, y, z}}) => [x, y, z].map(Math.fround));
    assert.deepEqual(pointsOf(cloud).map((point) => point.slice(0, 3)), expected.map((point) => point.map((value) => value + 0)));
  }
});

test('attachments are the files of the run', async () => {
  const {run, bytes} = bagOf('zstd');
  const {reader} = await readByIndex(bytes);
  for await (const attachment of reader.readAttachments({name: 'scenario.yaml', validateCrcs: true})) {
    assert.equal(new TextDecoder().decode(attachment.data), readFileSync(join(run, 'scenario.yaml'), 'utf8'));
  }
});

/** Some topics of a bag, decoded, encoded and written anew by packages that are not ours, without our metadata. */
async function rewritten(bytes, topics, options) {
  const {reader} = await readByIndex(bytes);
  const parts = [];
  const writable = {
    position: () => BigInt(parts.reduce((sum, part) => sum + part.length, 0)),
    write: async (part) => void parts.push(Buffer.from(part)),
  };
  const writer = new McapWriter({writable, ...options});
  await writer.start({profile: 'ros2', library: 'another'});
  const channels = new Map();
  for await (const message of reader.readMessages({topics})) {
    const {topic, schemaId} = reader.channelsById.get(message.channelId);
    const schema = reader.schemasById.get(schemaId);
    const definition = parse(new TextDecoder().decode(schema.data), {ros2: true});
    if (!channels.has(topic)) {
      const {name, encoding, data} = schema;
      channels.set(topic, await writer.registerChannel({
        topic, messageEncoding: 'cdr', metadata: new Map(),
        schemaId: await writer.registerSchema({name, encoding, data}),
      }));
    }
    const data = new MessageWriter(definition).writeMessage(new MessageReader(definition).readMessage(message.data));
    await writer.addMessage({...message, channelId: channels.get(topic), data});
  }
  await writer.end();
  return Buffer.concat(parts);
}

const rewrites = [
  ['/odom, in chunks', ['/scan', '/odom', '/tf_static', '/map', '/ground_truth/odom'], {}],
  ['/tf, without chunks or summary', ['/scan', '/tf', '/tf_static', '/map', '/ground_truth/odom'],
   {useChunks: false, useStatistics: false, useSummaryOffsets: false, repeatSchemas: false, repeatChannels: false}],
];
for (const [what, topics, options] of rewrites) {
  test(`a bag by another writer is replayed, odometry from ${what}`, async () => {
    const file = join(folder, 'another.mcap');
    writeFileSync(file, await rewritten(bagOf('zstd', 100).bytes, topics, options));
    const out = join(folder, 'replay');
    const summary = JSON.parse(castaway('replay', file, '--start', 'truth', '--no-pictures', '--json', '--out', out));
    const {tracking_error_m: error} = summary.localizers.mh_amcl;
    assert.ok(error.mean > 0 && error.mean < 0.05, `tracked within ${error.mean} m`);
  });
}
