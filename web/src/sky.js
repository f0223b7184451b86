// A dome in the colours of the sky, and the light that comes from it.
import { BackSide, Color, CubeTexture, DataTexture, DataUtils, HalfFloatType, LinearFilter, LinearMipmapLinearFilter, Mesh, ShaderMaterial, SphereGeometry } from "three";

const LEVELS = 4; // from a mirror to what a matt surface gathers
const SIZE = 64;
const HEIGHTS = 128; // of directions, from straight down to straight up
const RINGS = 32;
const TURNS = 16;

export const linear = (rgb) => new Color().setRGB(...rgb);

// How far up the sky a height is: 0 at the horizon and below it, 1 overhead. As in the dome's shader.
const up = (z) => Math.sqrt(Math.max(0, z));

export function dome(sky) {
  const material = new ShaderMaterial({
    side: BackSide,
    depthWrite: false,
    uniforms: { zenith: { value: linear(sky.zenith) }, horizon: { value: linear(sky.horizon) } },
    vertexShader: "varying vec3 way; void main() { way = position; gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0); }",
    fragmentShader:
      "uniform vec3 zenith, horizon; varying vec3 way; void main() { float up = clamp(normalize(way).z, 0.0, 1.0); gl_FragColor = vec4(mix(horizon, zenith, sqrt(up)), 1.0);\n#include <colorspace_fragment>\n}",
  });
  const mesh = new Mesh(new SphereGeometry(400, 32, 16), material);
  mesh.frustumCulled = false;
  return mesh;
}

// What a surface of this roughness that faces this height gathers, as a height of the sky: GGX seen
// head-on, as three's PMREMGenerator filters (for which a browser without a GPU needs seconds).
function gathered(z, roughness) {
  const alpha = roughness ** 4;
  const flat = Math.sqrt(Math.max(0, 1 - z * z));
  let sum = 0;
  let weights = 0;
  for (let ring = 0; ring < RINGS; ring++) {
    const u = (ring + 0.5) / RINGS;
    const c = (2 * (1 - u)) / (1 + (alpha - 1) * u) - 1; // of the angle to what is reflected
    if (c <= 0) break;
    const s = Math.sqrt(1 - c * c);
    for (let turn = 0; turn < TURNS; turn++) {
      sum += c * up(c * z + s * flat * Math.cos(((turn + 0.5) * 2 * Math.PI) / TURNS));
      weights += c;
    }
  }
  return sum / weights;
}

// The same as a colour.
const light = (sky, z, roughness) => linear(sky.horizon).lerp(linear(sky.zenith), gathered(z, roughness));

// What a matt surface gathers from above and from below.
export const skyMean = (sky) => [light(sky, 1, 1), light(sky, -1, 1)];

// The light of the sky from all directions for all roughnesses. It depends on the height alone.
export function skyLight(sky) {
  const levels = [];
  for (let level = 0; level <= LEVELS; level++) {
    const roughness = 1 - Math.sqrt(1 - Math.min(1, level / (LEVELS - 1)));
    const table = Array.from({ length: HEIGHTS + 1 }, (_, k) => [...light(sky, (2 * k) / HEIGHTS - 1, roughness).toArray(), 1].map(DataUtils.toHalfFloat));
    levels.push(faces(SIZE >> level, table));
  }
  const texture = new CubeTexture(levels[0], undefined, undefined, undefined, LinearFilter, LinearMipmapLinearFilter, undefined, HalfFloatType);
  texture.mipmaps = levels.slice(1).map((image) => ({ image, width: image[0].image.width }));
  texture.generateMipmaps = false;
  texture.isPMREMTexture = true; // it is filtered already
  texture.needsUpdate = true;
  return texture;
}

function faces(size, table) {
  return Array.from({ length: 6 }, (_, face) => {
    const data = new Uint16Array(4 * size * size);
    for (let row = 0; row < size; row++) {
      for (let column = 0; column < size; column++) {
        const s = (2 * (column + 0.5)) / size - 1;
        const t = (2 * (row + 0.5)) / size - 1;
        const z = [-s, s, t, -t, 1, -1][face] / Math.sqrt(1 + s * s + t * t);
        data.set(table[Math.round(((z + 1) * HEIGHTS) / 2)], 4 * (row * size + column));
      }
    }
    return new DataTexture(data, size, size, undefined, HalfFloatType);
  });
}
