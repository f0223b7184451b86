// The studio's page. Text only ever becomes text nodes: nothing is parsed as markup.

const STAGES = ["draft", "resolve", "cast", "layout", "optimize", "compile", "replay", "judge", "dress", "record"];
const EXAMPLES = [
  "A car collides with a trashbin, knocking it into a picnic table.",
  "A ball rolls off a table and lands in a basket.",
  "A bowling ball knocks down ten pins.",
  "A door is pushed open by a rolling ball.",
  "A cyclist brakes hard behind a parked van and stops.",
  "A wrecking ball swings into a stack of boxes.",
];
const PAUSE_MS = 60;
const TURNED_MS = 700;
const FILM_MS = 1500; // the player is loaded after this time, whatever keeps the film
const FATES = {
  used: "became an object, an event, a number or a relation",
  not_judged: "a statement: the replay will be measured by it",
  ignored: "left out: it changes nothing",
  not_represented: "the scene cannot show this",
  not_understood: "nothing was made of this",
};
const OUTCOMES = { solved: "good", partial: "fair", nearest_feasible: "fair", infeasible: "fair" };

const $ = (id) => document.getElementById(id);
const plain = (text) => String(text ?? "").replaceAll("_", " ");

function h(name, attributes = {}, ...children) {
  const element = document.createElement(name);
  for (const [key, value] of Object.entries(attributes)) {
    if (value === undefined || value === null || value === false) continue;
    if (key.startsWith("on")) element.addEventListener(key.slice(2), value);
    else element.setAttribute(key, value === true ? "" : String(value));
  }
  for (const child of children.flat(Infinity)) {
    if (child === undefined || child === null || child === false) continue;
    element.append(child instanceof Node ? child : String(child));
  }
  return element;
}

async function call(method, path, body) {
  const options = { method, headers: { "Content-Type": "application/json" } };
  if (body !== undefined) options.body = JSON.stringify(body);
  const answer = await fetch(path, options).catch(() => {
    throw new Error("The studio does not answer. What you wrote is kept: start esg studio again.");
  });
  const value = await answer.json().catch(() => ({ error: `the studio answered ${answer.status}` }));
  if (!answer.ok) throw new Error(value.error ?? value.detail ?? `the studio answered ${answer.status}`);
  return value;
}

// ---- what is written, and how it is read ----

const state = { reading: null, turned: new Map(), edited: false, shown: 0, jobs: [], asked: 0, reads: false };
let pause = 0;
let turning = 0;

// A tab keeps what is in it over reloads; a new tab begins with what was written last in any.
const DRAFT = "esg-studio-draft";

function keep() {
  const graph = state.edited ? $("graph").value : null;
  const draft = JSON.stringify({ ...asked(), turned: [...state.turned], graph });
  sessionStorage.setItem(DRAFT, draft);
  localStorage.setItem(DRAFT, draft);
}

function restore() {
  const draft = JSON.parse(sessionStorage.getItem(DRAFT) ?? localStorage.getItem(DRAFT) ?? "{}");
  $("prompt").value = draft.prompt ?? "";
  $("seed").value = String(draft.seed ?? 0);
  state.turned = new Map(draft.turned ?? []);
  if (draft.graph) {
    $("graph").value = draft.graph;
    $("graph-box").open = true;
    checkGraph();
  }
}

function asked() {
  return { prompt: $("prompt").value, seed: Number($("seed").value || 0) };
}

function mistake(error) {
  $("mistake").textContent = error ? error.message ?? String(error) : "";
}

// One at a time: what is typed meanwhile is read next, and only its last state.
async function read() {
  keep();
  const number = ++state.asked;
  if (state.reads) return;
  state.reads = true;
  await readNow(number);
  state.reads = false;
  if (number !== state.asked) read();
}

async function readNow(number) {
  const what = asked();
  if (!what.prompt.trim()) {
    state.reading = null;
    $("read").replaceChildren();
    $("notes").replaceChildren();
    $("knobs").replaceChildren();
    mistake();
    return;
  }
  try {
    const reading = await call("POST", "/api/read", what);
    if (number !== state.asked) return; // more was typed meanwhile
    state.reading = reading;
    mistake();
    showReading(reading);
  } catch (error) {
    if (number === state.asked) {
      $("read").replaceChildren();
      $("notes").replaceChildren();
      mistake(error);
    }
  }
}

function showReading(reading) {
  $("read").replaceChildren(
    ...reading.pieces.map((p) => (p.fate ? h("mark", { class: p.fate, title: [FATES[p.fate], ...p.notes].filter(Boolean).join("\n") }, p.text) : document.createTextNode(p.text))),
  );
  const note = (label, list) => list.length > 0 && h("p", {}, h("b", {}, `${label}: `), list.join(", "));
  $("notes").replaceChildren(
    ...[
      note("things", reading.objects),
      note("what happens", reading.events),
      ...reading.lost.map((l) => h("p", { class: "lost" }, `“${l.words}” will not be shown: ${l.reason || plain(l.status)}`)),
      ...reading.warnings.map((w) => h("p", { class: "lost" }, w)),
    ].filter(Boolean),
  );
  showKnobs(reading.knobs);
  if (!state.edited) {
    $("graph").value = reading.document;
    showViolations(reading.violations);
  }
}

// ---- sliders ----

const spot = (knob, value) => Math.round((1000 * Math.log(value / knob.low)) / Math.log(knob.high / knob.low));
const at = (knob, spot) => knob.low * (knob.high / knob.low) ** (spot / 1000);
const said = (value) => (value >= 100 ? value.toFixed(0) : Number(value.toPrecision(3)).toString());

function showKnobs(knobs) {
  const names = new Set(knobs.map((k) => k.id));
  for (const id of state.turned.keys()) if (!names.has(id)) state.turned.delete(id);
  $("knobs").replaceChildren(...(knobs.length ? knobs.map(slider) : [h("p", { class: "faint" }, "Nothing here has a number.")]));
}

function slider(knob) {
  const id = `knob-${knob.id}`;
  const output = h("output", { for: id });
  const box = h("div", { class: "knob" });
  const input = h("input", { id, type: "range", min: 0, max: 1000, step: 1, "data-knob": knob.id });
  const tell = () => {
    const value = state.turned.get(knob.id);
    const free = value === undefined && !knob.stated;
    box.classList.toggle("free", free);
    output.textContent = `${free ? "about " : ""}${said(value ?? knob.value)} ${knob.unit}`;
    input.setAttribute("aria-valuetext", output.textContent);
  };
  input.value = String(spot(knob, state.turned.get(knob.id) ?? knob.value));
  input.addEventListener("input", () => {
    state.turned.set(knob.id, Number(at(knob, Number(input.value)).toPrecision(4)));
    tell();
  });
  input.addEventListener("change", () => {
    keep();
    clearTimeout(turning);
    turning = setTimeout(() => make(true), TURNED_MS); // a key changes it a step at a time
  });
  tell();
  box.append(h("label", { for: id }, knob.label), output, input);
  return box;
}

// ---- the scene graph as text ----

function showViolations(violations) {
  const rows = violations.map((v) => h("li", {}, h("code", {}, `${v.code} ${v.pointer ?? ""}`), ` ${v.message} ${v.remedy ?? ""}`));
  $("violations").replaceChildren(...(rows.length ? rows : [h("li", { class: "fine" }, "It holds.")]));
  $("graph-go").disabled = rows.length > 0;
}

async function checkGraph() {
  state.edited = state.reading === null || $("graph").value !== state.reading.document;
  keep();
  try {
    showViolations((await call("POST", "/api/check", { document: $("graph").value })).violations);
  } catch (error) {
    mistake(error);
  }
}

// ---- making ----

async function make(withKnobs, document) {
  mistake();
  const body = asked();
  if (withKnobs && state.turned.size) body.knobs = Object.fromEntries(state.turned);
  if (document) body.document = document;
  try {
    const job = await call("POST", "/api/jobs", body);
    choose(job.id);
  } catch (error) {
    mistake(error);
  }
}

// ---- what is being made ----

function choose(id) {
  state.shown = id;
  history.replaceState(null, "", `#${id}`);
  show();
}

const running = (job) => job.status === "running" || job.status === "waiting";

function badge(job) {
  const text = job.outcome || job.status;
  const kind = job.outcome ? OUTCOMES[job.outcome] ?? "bad" : job.status === "failed" ? "bad" : "";
  return h("span", { class: `badge ${kind}` }, plain(text));
}

function stages(job) {
  const found = new Map(job.stages.map((s) => [s.name, s]));
  return h(
    "ol",
    { class: "stages", "aria-label": "Stages" },
    STAGES.filter((name) => name !== "dress" || found.has(name)).map((name) => {
      const s = found.get(name);
      const seconds = s && s.seconds !== null ? (s.cached ? "found" : `${s.seconds.toFixed(1)} s`) : s ? "…" : "";
      return h("li", { class: !s ? "" : s.seconds === null ? "now" : s.cached ? "cached" : "done", "aria-current": s && s.seconds === null ? "step" : undefined }, `${name} ${seconds}`.trim());
    }),
  );
}

// Rows that have not changed stay: whoever is at a button of one with the keyboard stays there.
const rows = new Map();

function showRows() {
  const found = state.jobs.slice().reverse().map((job) => {
    const { stages, ...told } = job;
    const key = JSON.stringify([told, job.id === state.shown]);
    const before = rows.get(job.id);
    if (before?.key === key) return before.element;
    const element = row(job);
    const there = before?.element.contains(document.activeElement);
    before?.element.replaceWith(element);
    if (there) element.querySelector("button").focus();
    rows.set(job.id, { key, element });
    return element;
  });
  const list = $("jobs");
  found.forEach((element, k) => list.children[k] !== element && list.insertBefore(element, list.children[k] ?? null));
  while (list.children.length > found.length) list.lastElementChild.remove();
}

function tell(job) {
  const stage = job.stages.find((s) => s.seconds === null);
  const text = stage ? `${job.status}: ${stage.name}` : `${plain(job.outcome || job.status)}. ${job.reason}`;
  if ($("told").textContent !== text) $("told").textContent = text;
}

let framed = "";

function show() {
  const job = state.jobs.find((j) => j.id === state.shown);
  showRows();
  if (!job) {
    $("job").replaceChildren(h("p", { class: "faint" }, "Nothing is being made yet."));
    $("scene").replaceChildren();
    framed = "";
    return;
  }
  const waiting = state.jobs.filter((j) => running(j) && j.id < job.id).length;
  $("job").replaceChildren(
    ...[
      h("p", { class: "row" }, h("strong", {}, job.prompt.slice(0, 300)), badge(job)),
      stages(job),
      job.status === "waiting" && h("p", { class: "faint" }, `${waiting} before it.`),
      job.reason && h("p", { class: job.outcome === "solved" ? "faint" : "mistake" }, job.reason),
      job.advice && job.outcome !== "solved" && h("p", { class: "faint" }, job.advice),
    ].filter(Boolean),
  );
  tell(job);
  const key = job.folder ? `${job.id}/${job.status}` : "";
  if (key === framed) return;
  framed = key;
  if (!key) {
    $("scene").replaceChildren();
    return;
  }
  const base = `/scenes/${job.id}`;
  $("scene").replaceChildren(...(job.status === "done" ? [downloads(base), player(base, job)] : [page(base, job)]));
}

function downloads(base) {
  const link = (to, text) => h("a", { href: `${base}/${to}`, download: "" }, text);
  return h(
    "div",
    { class: "downloads" },
    "Take it along:",
    ["usd", "glb", "mjcf", "unreal"].map((to) => link(`export/${to}`, to)),
    link("files/esg.json", "scene graph"),
    link("files/rollout.mcap", "MCAP"),
    link("files/preview.mp4", "film"),
    link("files/preview.png", "contact sheet"),
    h("a", { href: `${base}/`, target: "_blank" }, "open alone"),
  );
}

function page(base, job) {
  return h("iframe", { src: base && `${base}/`, title: `Scene of: ${job.prompt.slice(0, 120)}` });
}

// The film plays at once; it gives way to the 3-D player as soon as that has drawn.
function player(base, job) {
  const frame = page(null, job);
  const film = h("video", { src: `${base}/film`, title: `Film of: ${job.prompt.slice(0, 120)}`, muted: true, autoplay: true, loop: true, playsinline: true });
  film.muted = true; // the attribute alone does not count for elements made by scripts
  const box = h("div", { class: "player" }, frame, film);
  const load = () => frame.src || (frame.src = `${base}/`);
  film.addEventListener("playing", load, { once: true });
  film.addEventListener("error", () => (film.remove(), load()));
  setTimeout(load, FILM_MS);
  const waiting = setInterval(() => {
    const drawn = Boolean(frame.contentDocument?.querySelector(".stage[data-drawn]"));
    if (drawn) film.remove();
    if (drawn || !box.isConnected) clearInterval(waiting);
  }, 50);
  return box;
}

function row(job) {
  const again = () => {
    $("prompt").value = job.prompt;
    $("seed").value = String(job.seed);
    state.turned.clear();
    state.edited = false;
    read();
    $("prompt").focus();
  };
  return h(
    "li",
    { "aria-current": job.id === state.shown ? "true" : undefined, "data-job": job.id },
    h("button", { class: "text", type: "button", onclick: () => choose(job.id) }, job.prompt.slice(0, 300)),
    badge(job),
    h(
      "span",
      { class: "small" },
      `seed ${job.seed}${job.edited ? ", changed" : ""}`,
      running(job) && h("button", { type: "button", onclick: () => call("DELETE", `/api/jobs/${job.id}`).catch(mistake) }, "cancel"),
      !running(job) && h("button", { type: "button", onclick: again }, "write it again"),
    ),
  );
}

function listen() {
  const source = new EventSource("/api/stream");
  source.onmessage = (event) => {
    $("offline").hidden = true;
    state.jobs = JSON.parse(event.data);
    show();
  };
  source.onerror = () => {
    $("offline").hidden = false;
  };
}

// ---- start ----

restore();
state.shown = Number(location.hash.slice(1)) || 0;
$("examples").append(
  ...EXAMPLES.map((text) =>
    h("li", {}, h("button", { type: "button", onclick: () => {
      $("prompt").value = text;
      state.turned.clear();
      state.edited = false;
      read();
    } }, text)),
  ),
);
for (const id of ["prompt", "seed"]) {
  $(id).addEventListener("input", () => {
    state.turned.clear();
    state.edited = false;
    clearTimeout(pause);
    pause = setTimeout(read, PAUSE_MS);
  });
}
$("prompt").addEventListener("keydown", (event) => {
  if (event.key === "Enter" && (event.ctrlKey || event.metaKey)) make(true);
});
$("form").addEventListener("submit", (event) => {
  event.preventDefault();
  make(true);
});
$("graph").addEventListener("input", () => {
  clearTimeout(pause);
  pause = setTimeout(checkGraph, 250);
});
$("graph-go").addEventListener("click", () => make(false, $("graph").value));
$("graph-reset").addEventListener("click", () => {
  state.edited = false;
  $("graph").value = state.reading?.document ?? "";
  showViolations(state.reading?.violations ?? []);
  keep();
});
read();
listen();
