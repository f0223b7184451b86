// What surrounds the action: sky, light, ground and what stands there; surfaces and their pictures.
import {
  Box3,
  BufferAttribute,
  BufferGeometry,
  Color,
  DirectionalLight,
  Group,
  HemisphereLight,
  Mesh,
  MeshStandardMaterial,
  Ray,
  RepeatWrapping,
  SRGBColorSpace,
  TextureLoader,
  Vector3,
} from "three";
import { toCreasedNormals } from "three/addons/utils/BufferGeometryUtils.js";
import { mesh as loadMesh, pictureUrl } from "./data.js";
import { dome, linear, skyLight, skyMean } from "./sky.js";

const CREASE = 0.6;
const GROUND = new Set(["plane", "ground"]);
const SKY = 0.55;
const PLAIN = {
  kind: "plain",
  sun: [0.405, 0.45, 0.81],
  sun_rgb: [0.8, 0.78, 0.74],
  ambient_rgb: [0.34, 0.36, 0.4],
  zenith: [0.42, 0.56, 0.78],
  horizon: [0.72, 0.79, 0.86],
};

// Meshes of a chunk, one for each of its surfaces; `holder` names the group that takes one. Pictures
// are decoded after the first frame.
export function surfaces(m, holders, tint, begun, changed) {
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
    if (picture && tint === null) begun.then(() => wrap(material, picture, changed));
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

// Sky, light and surroundings of a page's scene, put into the player's world; `begun` its first frame.
export function setting(world, around, begun, changed) {
  const sky = around ?? PLAIN;
  const above = dome(sky);
  world.add(above);
  let light = null;
  world.environmentIntensity = SKY;
  // In a rough picture its mean stands for the sky.
  const mean = new HemisphereLight(...skyMean(sky), Math.PI * SKY);
  const ambient = new HemisphereLight(linear(sky.ambient_rgb), new Color(0x6a665e), 1.2);
  for (const from of [mean, ambient]) {
    from.position.set(0, 0, 1);
    world.add(from);
  }
  const sun = new DirectionalLight(linear(sky.sun_rgb), 2.6);
  sun.shadow.mapSize.set(2048, 2048);
  sun.shadow.normalBias = 0.02;
  sun.shadow.radius = sky.kind === "clear" ? 2 : 5;
  world.add(sun, sun.target);
  const things = new Map();
  const standing = around ? stand(world, around, things, begun, changed) : null;
  const toward = new Vector3(...sky.sun).normalize();
  const ray = new Ray();
  const hit = new Vector3();

  return {
    sun,
    toward,
    haze: linear(sky.horizon),
    standing,
    // Shadows and reflections, or what stands for them.
    fine(on) {
      sun.castShadow = on;
      if (on) light ??= skyLight(sky);
      world.environment = on ? light : null;
      mean.visible = !on;
    },
    // What stands between the eye and what it looks at is left out whole, as in a dollhouse.
    clear(eye, targets) {
      above.position.copy(eye);
      ray.origin.copy(eye);
      const hides = (box, target) => {
        ray.direction.copy(target).sub(eye);
        const away = ray.direction.length();
        ray.direction.normalize();
        const met = ray.intersectBox(box, hit);
        return met && hit.distanceTo(eye) < away;
      };
      for (const { group, box } of things.values()) {
        group.visible = !box.containsPoint(eye) && !targets.some((target) => hides(box, target));
      }
    },
    dispose: () => light?.dispose(),
  };
}

function stand(world, around, things, begun, changed) {
  return loadMesh(around.mesh).then((m) => {
    if (!m) return;
    for (const { mesh, holder } of surfaces(m, m.holders, null, begun, changed)) {
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
