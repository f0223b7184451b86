// The 3-D player: the scene's meshes, moved as the engines moved them.
import {
  ArrowHelper,
  Box3,
  BoxGeometry,
  BufferAttribute,
  BufferGeometry,
  CanvasTexture,
  Color,
  EdgesGeometry,
  Fog,
  Group,
  Line,
  LineBasicMaterial,
  LineSegments,
  Mesh,
  MeshBasicMaterial,
  MeshStandardMaterial,
  PCFShadowMap,
  PerspectiveCamera,
  PlaneGeometry,
  RepeatWrapping,
  Scene,
  SphereGeometry,
  Sprite,
  SpriteMaterial,
  SRGBColorSpace,
  Vector3,
  WebGLRenderer,
} from "three";
import { OrbitControls } from "three/addons/controls/OrbitControls.js";
import { mesh as loadMesh } from "./data.js";
import { h } from "./dom.js";
import { contextOf, createPace } from "./pace.js";
import { setting, surfaces } from "./setting.js";

const TINT = { physx: 0xd0342c, rapier: 0x2f7de1, newton: 0x1f9d55 };
const GROUND_WIDE_M = 45;
const LINGER_S = 0.35;
const FRAME_S = 1 / 60;
const ROUGH = 0.5; // pixels of a rough picture, in one direction

export function createPlayer(stage, view) {
  const { data, motions, s } = view;
  const canvas = document.createElement("canvas");
  let renderer;
  let pace;
  try {
    const { context, slow } = contextOf(canvas);
    renderer = new WebGLRenderer({ canvas, context });
    pace = createPace(slow);
  } catch {
    stage.replaceChildren(h("p", { class: "warn pad" }, "This browser offers no WebGL: the player cannot draw. The contact sheet below shows the scene."));
    stage.dataset.drawn = "";
    return silent();
  }
  canvas.tabIndex = 0;
  canvas.setAttribute("aria-label", "3-D view: drag to orbit, wheel to zoom, arrow keys to move");
  stage.replaceChildren(canvas);
  renderer.shadowMap.enabled = true;
  renderer.shadowMap.type = PCFShadowMap;
  const world = new Scene();
  world.background = new Color(0xcddbeb);
  const camera = new PerspectiveCamera(38, 1.5, 0.02, 600);
  camera.up.set(0, 0, 1);
  const orbit = new OrbitControls(camera, canvas);
  orbit.enableDamping = true;
  orbit.listenToKeyEvents(canvas);
  orbit.maxPolarAngle = Math.PI / 2 - 0.01;

  const end = Math.max(...motions.map((m) => m.end));
  const pose = new Float64Array(7);
  const listeners = [];
  const shown = { contacts: true, trails: true, names: false, shapes: false };
  let begin;
  const begun = new Promise((done) => (begin = done));
  const loading = [];
  const layers = motions.map((m, k) => layer(m, k));
  const cast = castOf(view);
  const span = extent();
  const scenery = setting(world, data.around, begun, () => (dirty = true));
  loading.push(scenery.standing);
  if (!data.around) ground();
  world.fog = new Fog(scenery.haze, 60, 190);
  const ropes = ropeLines();
  const marks = contactMarks();

  let time = 0;
  let playing = false;
  let rate = 1;
  let dirty = true;
  let alive = true;
  let before = 0;
  let fine = null;

  function layer(motion, k) {
    const group = new Group();
    group.visible = k === 0;
    let turning = 0;
    const bodies = data.bodies.map((body, i) => {
      const node = new Group();
      node.name = body.name;
      group.add(node);
      const box = new LineSegments(
        new EdgesGeometry(new BoxGeometry(2 * body.half[0], 2 * body.half[1], 2 * body.half[2])),
        new LineBasicMaterial({ color: TINT[motion.engine] ?? 0x888888 }),
      );
      box.position.set(body.offset[0], body.offset[1], body.offset[2] + body.half[2]);
      box.visible = false;
      node.add(box);
      const wheels = (body.wheels ?? []).map(([name, ...axle]) => pivot(name, axle, body.offset));
      const wide = !body.collides && Math.max(body.half[0], body.half[1]) > GROUND_WIDE_M;
      if (body.mesh && !wide && !data.around?.covered.includes(i) && (k === 0 || motion.column.has(i))) {
        const loaded = loadMesh(body.mesh).then((m) => {
          if (!alive || !m) return;
          const solid = build(m, k === 0 ? null : TINT[motion.engine], wheels, begun, () => (dirty = true));
          solid.position.set(...body.offset);
          if (!body.collides) solid.position.z += decalLift(i);
          solid.traverse((o) => {
            o.castShadow = body.collides && k === 0;
            o.receiveShadow = true;
          });
          node.add(solid);
          dirty = true;
        });
        loading.push(loaded);
      }
      const first = turning;
      turning += wheels.length;
      return { node, box, wheels, first };
    });
    world.add(group);
    const trails = new Group();
    trails.visible = k === 0;
    for (const body of motion.moving) {
      const points = [];
      for (let f = 0; f < motion.time.length; f++) points.push(...motion.center(body, f));
      const geometry = new BufferGeometry().setAttribute("position", new BufferAttribute(new Float32Array(points), 3));
      const line = new Line(geometry, new LineBasicMaterial({ color: k === 0 ? 0xffb400 : TINT[motion.engine], transparent: true, opacity: 0.75 }));
      line.userData.motion = motion;
      line.frustumCulled = false;
      trails.add(line);
    }
    world.add(trails);
    return { motion, group, bodies, trails, labels: null };
  }

  // Markings lie on the ground, the smaller on the larger: a few millimetres apart.
  function decalLift(i) {
    const area = (b) => b.half[0] * b.half[1];
    const larger = data.bodies.filter((b, j) => !b.collides && (area(b) > area(data.bodies[i]) || (area(b) === area(data.bodies[i]) && j < i)));
    // Their upper side counts: a floor is drawn a centimetre thick.
    return 0.004 * (1 + larger.length) - 2 * data.bodies[i].half[2];
  }

  function castOf() {
    const names = new Set(s.events.flatMap((e) => e.bodies ?? []));
    const found = data.bodies.map((b, i) => (names.has(b.name) ? i : -1)).filter((i) => i >= 0);
    if (found.length) return found;
    return motions[0].moving.length ? motions[0].moving : data.bodies.map((b, i) => (b.collides ? i : -1)).filter((i) => i >= 0);
  }

  function extent() {
    const box = new Box3();
    for (const body of castOf()) {
      motions[0].pose(body, 0, pose);
      box.expandByPoint(new Vector3(pose[0], pose[1], pose[2]));
    }
    return Math.max(2, box.getSize(new Vector3()).length());
  }

  function moveSun(center, reach) {
    const { sun, toward } = scenery;
    sun.target.position.copy(center);
    sun.position.copy(center).addScaledVector(toward, 2.5 * reach);
    const c = sun.shadow.camera;
    c.left = c.bottom = -1.3 * reach;
    c.right = c.top = 1.3 * reach;
    c.near = 0.05 * reach;
    c.far = 6 * reach;
    c.updateProjectionMatrix();
  }

  function ground() {
    const wide = data.bodies.find((b) => !b.collides && Math.max(b.half[0], b.half[1]) > GROUND_WIDE_M);
    const color = new Color(...(wide?.color ?? (data.document.scene_definition?.scene_parameters?.scene_type === "indoor" ? [0.47, 0.41, 0.35] : [0.36, 0.38, 0.36])));
    const picture = document.createElement("canvas");
    picture.width = picture.height = 2;
    const draw = picture.getContext("2d");
    draw.fillStyle = "#fff";
    draw.fillRect(0, 0, 2, 2);
    draw.fillStyle = "#e2e2e2";
    draw.fillRect(0, 0, 1, 1);
    draw.fillRect(1, 1, 1, 1);
    const texture = new CanvasTexture(picture);
    texture.wrapS = texture.wrapT = RepeatWrapping;
    texture.colorSpace = SRGBColorSpace;
    texture.magFilter = 1003;
    texture.anisotropy = 8;
    const tile = span < 3 ? 0.25 : 1;
    const size = 400;
    texture.repeat.set(size / (2 * tile), size / (2 * tile));
    const plane = new Mesh(new PlaneGeometry(size, size), new MeshStandardMaterial({ color, map: texture, roughness: 1 }));
    // Millimetres are within the error of depth on triangles this large: roads sank in small players.
    Object.assign(plane.material, { polygonOffset: true, polygonOffsetFactor: 2, polygonOffsetUnits: 16 });
    plane.position.z = -0.004;
    plane.receiveShadow = true;
    world.add(plane);
  }

  // Ropes and springs have no mesh: lines between what they hold.
  function ropeLines() {
    return (data.ropes ?? []).map((rope) => {
      const geometry = new BufferGeometry().setAttribute("position", new BufferAttribute(new Float32Array(6), 3));
      const line = new Line(geometry, new LineBasicMaterial({ color: 0x2e2822 }));
      line.frustumCulled = false;
      world.add(line);
      return { ...rope, line };
    });
  }

  function tip(body, point) {
    const at = new Vector3(...point);
    if (body < 0) return at;
    const { node } = layers[0].bodies[body];
    return at.applyQuaternion(node.quaternion).add(node.position);
  }

  function contactMarks() {
    const group = new Group();
    const strongest = Math.max(1e-6, ...motions[0].contacts.map((c) => c[3]));
    for (const c of motions[0].contacts) {
      const size = 0.25 + 0.75 * Math.sqrt(c[3] / strongest);
      const mark = new Group();
      const material = new MeshBasicMaterial({ color: 0xff3b1f, transparent: true, depthTest: false });
      const ball = new Mesh(new SphereGeometry(0.012 * span * size, 12, 8), material);
      const arrow = new ArrowHelper(new Vector3(c[7], c[8], c[9]).normalize(), new Vector3(), 0.16 * span * size, 0xff3b1f, 0.05 * span * size, 0.03 * span * size);
      for (const part of [arrow.line, arrow.cone]) {
        part.material.transparent = true;
        part.material.depthTest = false;
      }
      ball.renderOrder = arrow.renderOrder = 5;
      mark.add(ball, arrow);
      mark.position.set(c[4], c[5], c[6]);
      mark.userData = { time: c[0], materials: [material, arrow.line.material, arrow.cone.material] };
      mark.visible = false;
      group.add(mark);
    }
    world.add(group);
    return group.children;
  }

  function labels(on) {
    const { bodies } = layers[0];
    for (const i of cast) {
      let sprite = bodies[i].label;
      if (!sprite && on) {
        sprite = bodies[i].label = nameTag(data.bodies[i], span);
        bodies[i].node.add(sprite);
      }
      if (sprite) sprite.visible = on;
    }
  }

  function resize() {
    const width = stage.clientWidth || 720;
    const height = Math.max(240, Math.min(Math.round(width * 0.62), Math.round(window.innerHeight * 0.7)));
    renderer.setSize(width, height);
    camera.aspect = width / height;
    camera.updateProjectionMatrix();
    dirty = true;
  }

  // A camera beside the motion that holds the participants at this moment.
  function frame() {
    const box = new Box3();
    const near = s.events.filter((e) => e.time_s !== null && Math.abs(e.time_s - time) < 0.1);
    const now = near.flatMap((e) => e.bodies ?? []);
    const wanted = now.length ? cast.filter((i) => now.includes(data.bodies[i].name)) : cast;
    for (const i of wanted.length ? wanted : cast) {
      motions[0].pose(i, time, pose);
      const r = Math.min(6, Math.hypot(...data.bodies[i].half));
      const at = new Vector3(pose[0], pose[1], pose[2]);
      box.expandByPoint(at.clone().addScalar(r));
      box.expandByPoint(at.addScalar(-r));
    }
    box.min.z = Math.max(0, box.min.z);
    const center = box.getCenter(new Vector3());
    const reach = Math.max(0.15, box.getSize(new Vector3()).length() / 2);
    let along = new Vector3(1, 0, 0);
    let longest = 0.2;
    const last = motions[0].time.length - 1;
    for (const i of cast) {
      const a = motions[0].center(i, 0);
      const b = motions[0].center(i, last);
      const way = new Vector3(b[0] - a[0], b[1] - a[1], 0);
      if (way.length() > longest) {
        longest = way.length();
        along = way.normalize();
      }
    }
    const side = new Vector3(-along.y, along.x, 0);
    if (side.y < -1e-6) side.negate();
    const distance = (1.02 * reach) / Math.sin((camera.fov * Math.PI) / 360);
    camera.position.copy(center).addScaledVector(side, distance * 0.9).add(new Vector3(0, 0, distance * 0.42));
    camera.near = Math.max(0.005, distance / 200);
    camera.far = distance * 40 + 300;
    camera.updateProjectionMatrix();
    orbit.target.copy(center);
    orbit.update();
    moveSun(center, Math.max(1.5 * reach, 1));
    world.fog.near = Math.max(60, 3 * distance);
    world.fog.far = Math.max(190, 12 * distance);
    dirty = true;
  }

  function place() {
    for (const { motion, group, bodies, trails } of layers) {
      if (!group.visible) continue;
      for (let i = 0; i < bodies.length; i++) {
        motion.pose(i, time, pose);
        bodies[i].node.position.set(pose[0], pose[1], pose[2]);
        bodies[i].node.quaternion.set(pose[3], pose[4], pose[5], pose[6]);
        bodies[i].wheels.forEach((wheel, w) => (wheel.rotation.y = motion.angle(bodies[i].first + w, time)));
      }
      const [f] = motion.at(time);
      for (const line of trails.children) line.geometry.setDrawRange(0, f + 1);
    }
    for (const { line, a, b, from, to, length } of ropes) {
      const ends = [tip(a, from), tip(b, to)];
      const place = line.geometry.getAttribute("position");
      ends.forEach((p, k) => place.setXYZ(k, p.x, p.y, p.z));
      place.needsUpdate = true;
      line.visible = length === null || ends[0].distanceTo(ends[1]) <= length;
    }
    for (const mark of marks) {
      const age = time - mark.userData.time;
      mark.visible = shown.contacts && age >= -1e-9 && age < LINGER_S;
      if (mark.visible) for (const m of mark.userData.materials) m.opacity = 1 - age / LINGER_S;
    }
  }

  function tell() {
    for (const f of listeners) f(time, playing);
  }

  function seek(t) {
    time = Math.min(end, Math.max(0, t));
    place();
    tell();
    dirty = true;
  }

  function toggle() {
    playing = !playing;
    if (playing && time >= end - 1e-6) time = 0;
    before = performance.now();
    tell();
  }

  function loop(now) {
    if (!alive) return;
    requestAnimationFrame(loop);
    if (playing) {
      time += Math.min(0.1, (now - before) / 1000) * rate;
      if (time >= end) {
        time = end;
        playing = false;
      }
      place();
      tell();
      dirty = true;
    }
    before = now;
    if (orbit.update()) dirty = true;
    const wanted = pace.next(now, dirty);
    dirty = false;
    if (wanted) draw(wanted === "fine");
  }

  function draw(finely) {
    if (finely !== fine) {
      fine = finely;
      scenery.fine(fine);
      renderer.setPixelRatio(Math.min(2, window.devicePixelRatio) * (fine ? 1 : ROUGH));
    }
    scenery.clear(camera.position, [orbit.target, ...cast.map((i) => layers[0].bodies[i].node.position)]);
    renderer.render(world, camera);
  }

  const jump = (sign) => {
    const times = s.events.map((e) => e.time_s).filter((t) => t !== null && t !== undefined).sort((a, b) => a - b);
    const next = sign > 0 ? times.find((t) => t > time + 1e-3) : times.findLast((t) => t < time - 1e-3);
    seek(next ?? (sign > 0 ? end : 0));
  };
  const keys = {
    " ": toggle,
    ",": () => seek(time - FRAME_S),
    ".": () => seek(time + FRAME_S),
    n: () => jump(1),
    p: () => jump(-1),
    f: frame,
  };
  const watcher = new ResizeObserver(resize);
  watcher.observe(stage);
  resize();
  place();
  frame();
  Promise.allSettled(loading).then((found) => {
    for (const { reason } of found) if (reason) console.error(reason); // what is sound is drawn
    if (!alive) return;
    requestAnimationFrame(loop);
    requestAnimationFrame(() => requestAnimationFrame(() => ((stage.dataset.drawn = ""), begin())));
  });

  return {
    listen: (f) => listeners.push(f),
    seek,
    toggle,
    frame,
    rate(value) {
      rate = value;
    },
    show(key, on) {
      shown[key] = on;
      if (key === "trails") for (const l of layers) l.trails.visible = on && l.group.visible;
      if (key === "shapes") for (const l of layers) l.bodies.forEach((b, i) => (b.box.visible = on && data.bodies[i].collides));
      if (key === "names") labels(on);
      place();
      dirty = true;
    },
    engine(k, on) {
      layers[k].group.visible = on;
      layers[k].trails.visible = on && shown.trails;
      place();
      dirty = true;
    },
    key(key, target) {
      if (key === " " && target.tagName === "BUTTON") return false;
      if (!keys[key]) return false;
      keys[key]();
      return true;
    },
    dispose() {
      alive = false;
      watcher.disconnect();
      scenery.dispose();
      orbit.dispose();
      world.traverse((o) => {
        o.geometry?.dispose();
        for (const m of [o.material].flat()) {
          m?.map?.dispose();
          m?.dispose?.();
        }
      });
      renderer.dispose();
      renderer.forceContextLoss();
    },
  };
}

// A group that turns about an axle along Y, given from the body's centre of mass.
function pivot(name, axle, offset) {
  const wheel = new Group();
  wheel.name = name;
  wheel.position.set(axle[0] - offset[0], axle[1] - offset[1], axle[2] - offset[2]);
  return wheel;
}

function build(m, tint, wheels, begun, changed) {
  const group = new Group();
  for (const { mesh, holder } of surfaces(m, m.wheels, tint, begun, changed)) {
    const wheel = wheels.find((w) => w.name && w.name === holder);
    if (wheel) mesh.position.copy(wheel.position).negate();
    (wheel ?? group).add(mesh);
  }
  for (const wheel of wheels) group.add(wheel);
  return group;
}

function nameTag(body, span) {
  const picture = document.createElement("canvas");
  const draw = picture.getContext("2d");
  const font = "28px system-ui, sans-serif";
  draw.font = font;
  const width = Math.ceil(draw.measureText(body.label).width) + 20;
  picture.width = width;
  picture.height = 44;
  draw.font = font;
  draw.fillStyle = "rgba(20, 24, 30, 0.8)";
  draw.fillRect(0, 0, width, 44);
  draw.fillStyle = "#fff";
  draw.fillText(body.label, 10, 31);
  const texture = new CanvasTexture(picture);
  texture.colorSpace = SRGBColorSpace;
  const sprite = new Sprite(new SpriteMaterial({ map: texture, depthTest: false, transparent: true }));
  const height = 0.04 * span;
  sprite.scale.set((height * width) / 44, height, 1);
  sprite.position.set(body.offset[0], body.offset[1], body.offset[2] + 2 * body.half[2] + 0.8 * height);
  sprite.renderOrder = 9;
  return sprite;
}

function silent() {
  const nothing = () => {};
  return { listen: nothing, seek: nothing, toggle: nothing, frame: nothing, rate: nothing, show: nothing, engine: nothing, key: () => false, dispose: nothing };
}
