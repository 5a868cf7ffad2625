// Frames of a live run, as tools/live/live_feed.hpp writes them.

const kText = new TextDecoder();

/** The JSON of a frame and its blocks of bytes. */
export function readFrame(buffer) {
  const bytes = new Uint8Array(buffer);
  const size = new DataView(buffer).getUint32(0, true);
  const head = JSON.parse(kText.decode(bytes.subarray(4, 4 + size)));
  const blocks = [];
  let at = 4 + size;
  for (const length of head.blocks) {
    blocks.push(bytes.subarray(at, at + length));
    at += length;
  }
  return {...head, blocks};
}
