// Chunks of the page, decoded when they are first needed (esg/report/binary.py writes them).

const text = (id) => document.getElementById(id)?.textContent ?? "";

export const index = JSON.parse(text("index"));
export const licenses = () => JSON.parse(text("licenses"));

function binary(base64) {
  const raw = atob(base64);
  const out = new Uint8Array(raw.length);
  for (let i = 0; i < raw.length; i++) out[i] = raw.charCodeAt(i);
  return out;
}

export function imageUrl(base64) {
  return URL.createObjectURL(new Blob([binary(base64)], { type: "image/webp" }));
}

export function filmUrl(base64) {
  return URL.createObjectURL(new Blob([binary(base64)], { type: "video/mp4" }));
}

export function pictureUrl(key) {
  const base64 = text(`picture-${key}`);
  return base64 ? imageUrl(base64) : "";
}

export function thumbnail(n) {
  const base64 = text(`thumb-${n}`);
  return base64 ? imageUrl(base64) : "";
}

async function chunk(id) {
  const base64 = text(id);
  if (!base64) return null;
  const stream = new Blob([binary(base64)]).stream().pipeThrough(new DecompressionStream("gzip"));
  const buffer = await new Response(stream).arrayBuffer();
  const length = new DataView(buffer).getUint32(0, true);
  const head = JSON.parse(new TextDecoder().decode(new Uint8Array(buffer, 4, length)));
  const arrays = {};
  for (const entry of head.arrays) arrays[entry.name] = decode(buffer, 4 + length, entry);
  return { ...head, arrays };
}

function decode(buffer, start, { type, shape, offset, low, step, delta }) {
  const count = shape.reduce((a, b) => a * b, 1);
  const at = start + offset;
  if (type === "u4") return new Uint32Array(buffer, at, count);
  const codes = new Uint16Array(buffer, at, count);
  if (!low) return codes;
  // Columns one after the other; rows are what everybody wants.
  const [rows, columns] = shape;
  const out = new Float32Array(count);
  for (let c = 0; c < columns; c++) {
    let code = 0;
    for (let r = 0; r < rows; r++) {
      const read = codes[c * rows + r];
      code = delta ? (code + read) & 0xffff : read;
      out[r * columns + c] = low[c] + step[c] * code;
    }
  }
  return out;
}

// Only the scene that is shown is kept, so that browsing hundreds of scenes does not add up.
let last = { n: -1, promise: null };

export function scene(n) {
  if (last.n !== n) last = { n, promise: chunk(`scene-${n}`) };
  return last.promise;
}

const meshes = new Map();
const KEPT_MESHES = 64;

export function mesh(key) {
  const found = meshes.get(key) ?? chunk(`mesh-${key}`);
  meshes.delete(key);
  meshes.set(key, found);
  if (meshes.size > KEPT_MESHES) meshes.delete(meshes.keys().next().value);
  return found;
}
