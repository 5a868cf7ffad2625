// From the text in the page to bytes.

/** The bytes that base64 text stands for. */
export function fromBase64(text) {
  const binary = atob(text);
  const bytes = new Uint8Array(binary.length);
  for (let i = 0; i < binary.length; ++i) bytes[i] = binary.charCodeAt(i);
  return bytes;
}

/** What a gzip stream holds. Rejects if it is none, damaged or cut off. */
export async function gunzip(bytes) {
  if (typeof DecompressionStream === 'undefined') {
    throw new Error('this browser cannot unpack the recording; take one of 2023 or later');
  }
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream('gzip'));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}
