// What surrounds the action: sky, light, ground and what stands there; surfaces and their pictures.
import {
  BackSide,
  Box3,
  BufferAttribute,
  BufferGeometry,
  Color,
  DirectionalLight,
  Group,
  HemisphereLight,
  Mesh,
  MeshStandardMaterial,
  PMREMGenerator,
  Ray,
  RepeatWrapping,
  Scene,
  ShaderMaterial,
  SphereGeometry,
  SRGBColorSpace,
  TextureLoader,
  Vector3,
} from "three";
import { toCreasedNormals } from "three/addons/utils/BufferGeometryUtils.js";
import { mesh as loadMesh, pictureUrl } from "./data.js";

const CREASE = 0.6;
const GROUND = new Set(["plane", "ground"]);
const PLAIN = {
  kind: "plain",
  sun: [0.405, 0.45, 0.81],
  sun_rgb: [0.8, 0.78, 0.74],
  ambient_rgb: [0.34, 0.36, 0.4],
  zenith: [0.42, 0.56, 0.78],
  horizon: [0.72, 0.79, 0.86],
};

const linear = (rgb) => new Color().setRGB(...rgb);

// Meshes of a chunk, one for each of its surfaces; `holder` names the group that takes one.
export function surfaces(m, holders, tint, changed) {
  const positions = new BufferAttribute(m.arrays.vertices, 3);
  const uvs = m.arrays.uvs && new BufferAttribute(m.arrays.uvs, 2);
  let start = 0;
  return m.counts.map((count, k) => {
    const part = new BufferGeometry();
    part.setAttribute("position", positions);
    const [roughness, metalness, picture] = m.surfaces?.[k] ?? [0.75, 0, ""];
    if (uvs && picture) part.setAttribute("uv", uvs);
    part.setIndex(new BufferAttribute(m.arrays.index.slice(start, start + count), 1));
    start += count;
    const [r, g, b, a] = m.colors[k];
    const color = tint === null ? new Color().setRGB(r, g, b, SRGBColorSpace) : new Color(tint);
    const opacity = tint === null ? (a ?? 1) : 0.45;
    const material = new MeshStandardMaterial({ color, roughness, metalness, transparent: opacity < 1, opacity, depthWrite: opacity >= 1 });
    if (picture && tint === null) wrap(material, picture, changed);
    return { mesh: new Mesh(toCreasedNormals(part, CREASE), material), holder: holders?.[k] ?? "" };
  });
}

function wrap(material, key, changed) {
  const url = pictureUrl(key);
  if (!url) return;
  new TextureLoader().load(url, (texture) => {
    texture.wrapS = texture.wrapT = RepeatWrapping;
    texture.colorSpace = SRGBColorSpace;
    texture.anisotropy = 8;
    material.map = texture;
    material.needsUpdate = true;
    URL.revokeObjectURL(url);
    changed();
  });
}

// A dome in the colours of the sky, which also lights everything.
function dome(sky) {
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

// Sky, light and surroundings of a page's scene, put into the player's world.
export function setting(world, renderer, around, changed) {
  const sky = around ?? PLAIN;
  const above = dome(sky);
  world.add(above);
  const lit = new Scene();
  lit.add(dome(sky));
  const baker = new PMREMGenerator(renderer);
  const baked = baker.fromScene(lit, 0, 0.1, 1000);
  baker.dispose();
  world.environment = baked.texture;
  world.environmentIntensity = 0.55;
  world.add(new HemisphereLight(linear(sky.ambient_rgb), new Color(0x6a665e), 1.2));
  const sun = new DirectionalLight(linear(sky.sun_rgb), 2.6);
  sun.castShadow = true;
  sun.shadow.mapSize.set(2048, 2048);
  sun.shadow.normalBias = 0.02;
  sun.shadow.radius = sky.kind === "clear" ? 2 : 5;
  world.add(sun, sun.target);
  const things = new Map();
  if (around) stand(world, around, things, changed);
  const toward = new Vector3(...sky.sun).normalize();
  const ray = new Ray();
  const hit = new Vector3();

  return {
    sun,
    toward,
    haze: linear(sky.horizon),
    // What stands between the eye and what it looks at is left out whole, as in a dollhouse.
    clear(eye, target) {
      above.position.copy(eye);
      ray.origin.copy(eye);
      ray.direction.copy(target).sub(eye);
      const away = ray.direction.length();
      ray.direction.normalize();
      for (const { group, box } of things.values()) {
        const met = ray.intersectBox(box, hit);
        group.visible = !(box.containsPoint(eye) || (met && hit.distanceTo(eye) < away));
      }
    },
    dispose: () => baked.dispose(),
  };
}

function stand(world, around, things, changed) {
  loadMesh(around.mesh).then((m) => {
    if (!m) return;
    for (const { mesh, holder } of surfaces(m, m.holders, null, changed)) {
      mesh.receiveShadow = true;
      if (GROUND.has(holder)) {
        Object.assign(mesh.material, { polygonOffset: true, polygonOffsetFactor: holder === "plane" ? 2 : 1, polygonOffsetUnits: holder === "plane" ? 16 : 8 });
        if (holder === "plane") mesh.position.z = -0.004;
        world.add(mesh);
        continue;
      }
      mesh.castShadow = true;
      if (!things.has(holder)) {
        const group = new Group();
        things.set(holder, { group, box: new Box3() });
        world.add(group);
      }
      const thing = things.get(holder);
      thing.group.add(mesh);
      mesh.geometry.computeBoundingBox();
      thing.box.union(mesh.geometry.boundingBox);
    }
    changed();
  });
}
