// The page of one scene.
import { filmUrl, imageUrl, index, scene as load } from "./data.js";
import { badge, breakable, bytes, called, h, number, percent, words } from "./dom.js";
import { spatialGraph, timelineGraph } from "./graph.js";
import { Motion } from "./motion.js";
import { createPlayer } from "./player.js";
import { plots } from "./plots.js";

export async function detail(s) {
  const data = await load(s.n);
  const urls = [];
  const release = [];
  const motions = data.replays.map((r, k) => new Motion(r, data.arrays, k));
  const view = { s, data, motions, names: data.bodies.map((b) => b.label) };
  let player = null;
  const stage = h("div", { class: "stage" });
  const controls = motions.length ? controlPanel(view, () => player) : null;
  const graphs = motions.length ? plots(view, (t) => player?.seek(t)) : null;

  const element = h(
    "article",
    { class: "detail" },
    h("h1", { class: "row wrap" }, h("span", {}, breakable(s.id)), badge(s.outcome)),
    prompt(data),
    s.problems.map((p) => h("p", { class: "warn" }, p)),
    s.reason && h("p", { class: s.outcome === "solved" ? "" : "warn", id: "reason" }, s.reason),
    s.outcome !== "solved" && s.advice && h("p", { class: "faint" }, s.advice),
    h("div", { class: "two" }, h("div", {}, stage, controls?.element, film(data, urls)), h("div", {}, events(view, () => player), statements(data.statements, "Statements", "statements"), statements(data.asked, "Statements of the suite", "asked"), plausibility(data.metrics.plausibility), constraints(data), engines(view))),
    graphs?.element,
    section("Scene graph", graphTabs(data)),
    section("Optimizer", optimizer(data)),
    section("Emitted class", sources(data)),
    section("Contact sheet", sheet(data, urls)),
    section("Stages", stages(data)),
    section("Downloads", downloads(s, data, urls)),
  );

  return {
    element,
    shown() {
      if (!motions.length) {
        stage.replaceChildren(h("p", { class: "faint pad" }, s.problems.length ? "Its files are damaged: there is nothing to play." : "This scene was never replayed: there is nothing to play."));
        stage.dataset.drawn = "";
        return;
      }
      player = createPlayer(stage, view);
      player.listen((t, playing) => {
        controls.update(t, playing);
        graphs.update(t);
      });
      release.push(() => player.dispose());
      player.seek(0);
    },
    key: (key, target) => player?.key(key, target) ?? false,
    dispose() {
      for (const undo of release) undo();
      for (const url of urls) URL.revokeObjectURL(url);
    },
  };
}

function section(title, content, open = false) {
  if (!content) return null;
  return h("details", { class: "section", open }, h("summary", {}, title), content);
}

// What became of words: a sign beside the colour, and what it means.
const FATES = {
  used: ["", "became an object, an event, a number or a relation"],
  kept: ["✓", "stated, and true in the replay"],
  broken: ["✗", "stated, but not true in the replay"],
  not_represented: ["∅", "stated, but the scene cannot hold it"],
  not_understood: ["?", "nothing was made of it"],
  not_judged: ["…", "stated, but never replayed"],
  ignored: ["–", "left out: it changes nothing"],
};

const fate = (name, sign, more, ...text) => h("mark", { class: `cover ${name}`, "data-sign": sign || undefined, ...more }, ...text);

// The prompt with every piece marked by what became of it; Tab and hovering tell what was measured.
function prompt(data) {
  const found = new Set(data.words.map((w) => w.fate).filter(Boolean));
  const parts = data.words.map((w) => {
    const [sign] = FATES[w.fate] ?? [""];
    const notes = w.notes.join("\n");
    return w.fate ? fate(w.fate, sign, { title: notes, tabindex: w.fate === "used" ? undefined : "0", "aria-description": notes }, w.text) : w.text;
  });
  return h(
    "div",
    {},
    h("p", { class: "prompt large" }, parts),
    found.size > 0 &&
      h(
        "ul",
        { class: "fates", "aria-label": "What the marks mean" },
        Object.entries(FATES)
          .filter(([name]) => found.has(name))
          .map(([name, [sign, meaning]]) => h("li", {}, fate(name, sign, {}, words(name)), ` ${meaning}`)),
      ),
    (data.document.coverage?.warnings ?? []).map((w) => h("p", { class: "warn" }, w)),
  );
}

// Units that the names of measured values end in.
const UNITS = { mps: "m/s", m: "m", s: "s", deg: "°", ns: "N s", kg: "kg" };

function quantity(key, value) {
  const at = key.lastIndexOf("_");
  const unit = at > 0 ? UNITS[key.slice(at + 1)] : undefined;
  return unit ? `${words(key.slice(0, at))} ${number(value)} ${unit}` : `${words(key)} ${number(value)}`;
}

// What the replay shows against what nature allows: a row a check.
function plausibility(found) {
  if (!found) return null;
  const failed = found.checks.filter((c) => !c.ok).length;
  const size = (value, unit) => (value === null ? "–" : `${number(value, 3)} ${unit}`);
  const where = (c) => [c.body, c.time_s === null ? "" : `${number(c.time_s, 2)} s`, c.note].filter(Boolean).join(", ");
  return h(
    "div",
    { id: "plausibility", class: "statements" },
    h("h2", {}, failed ? `Not plausible: ${failed} of ${found.checks.length} checks fail` : "Plausible"),
    h(
      "table",
      { class: "figures" },
      h("thead", {}, h("tr", {}, ["check", "measured", "limit", "where"].map((c) => h("th", { scope: "col" }, c)))),
      h(
        "tbody",
        {},
        found.checks.map((c) =>
          h(
            "tr",
            { class: c.ok ? "" : "failed" },
            h("th", { scope: "row" }, `${c.ok ? "✓" : "✗"} ${words(c.name)}`),
            h("td", {}, size(c.measured, c.unit)),
            h("td", {}, size(c.limit, c.unit)),
            h("td", {}, c.measured === null ? "nothing to measure" : where(c)),
          ),
        ),
      ),
    ),
  );
}

function statements(rows, title, id) {
  if (!rows.length) return null;
  const kept = rows.filter((r) => r.status === "kept").length;
  return h(
    "div",
    { id, class: "statements" },
    h("h2", {}, `${title}: ${kept} of ${rows.length} kept`),
    h(
      "table",
      { class: "figures" },
      h("thead", {}, h("tr", {}, ["words", "states", "verdict", "measured"].map((c) => h("th", { scope: "col" }, c)))),
      h(
        "tbody",
        {},
        rows.map((r) =>
          h(
            "tr",
            { class: r.status === "kept" ? "" : "failed" },
            h("th", { scope: "row" }, r.words || r.id),
            h("td", {}, words(r.says)),
            h("td", {}, `${FATES[r.status]?.[0] ?? ""} ${words(r.status)}`),
            h("td", {}, [Object.entries(r.measured).map(([k, v]) => quantity(k, v)).join(", "), r.reason].filter(Boolean).join("; ") || "–"),
          ),
        ),
      ),
    ),
  );
}

function controlPanel(view, player) {
  const { motions, s } = view;
  const end = Math.max(...motions.map((m) => m.end));
  const play = h("button", { type: "button", id: "play", onclick: () => player()?.toggle() }, "play");
  const range = h("input", {
    type: "range",
    id: "scrub",
    min: 0,
    max: end,
    step: 1 / 240,
    value: 0,
    "aria-label": "time in seconds",
    oninput: () => player()?.seek(Number(range.value)),
  });
  const clock = h("output", { id: "clock", for: "scrub" }, "0.00 s");
  const marks = s.events
    .filter((e) => e.time_s !== null && e.time_s !== undefined)
    .map((e) =>
      h("button", {
        type: "button",
        class: `tick ${e.completed ? "good" : "bad"}`,
        style: `left:${(100 * e.time_s) / end}%`,
        title: `${e.id} ${e.type} at ${e.time_s.toFixed(2)} s`,
        "aria-label": `go to ${e.id} ${e.type} at ${e.time_s.toFixed(2)} s`,
        onclick: () => player()?.seek(e.time_s),
      }),
    );
  const speed = h(
    "select",
    { id: "rate", "aria-label": "playback speed", onchange: () => player()?.rate(Number(speed.value)) },
    [0.1, 0.25, 0.5, 1, 2].map((r) => h("option", { value: r, selected: r === 1 }, `${r}×`)),
  );
  const toggles = [
    ["contacts", "contacts", true],
    ["trails", "trails", true],
    ["names", "names", false],
    ["shapes", "collision boxes", false],
  ].map(([key, text, on]) =>
    h("label", {}, h("input", { type: "checkbox", id: `show-${key}`, checked: on, onchange: (e) => player()?.show(key, e.target.checked) }), text),
  );
  const overlay = motions.map((m, k) =>
    h(
      "label",
      { class: `engine engine-${m.engine}` },
      h("input", {
        type: "checkbox",
        id: `engine-${m.engine}`,
        checked: k === 0,
        onchange: (e) => player()?.engine(k, e.target.checked),
      }),
      m.engine,
    ),
  );
  const element = h(
    "div",
    { class: "controls" },
    h("div", { class: "row" }, play, h("div", { class: "track" }, range, marks), clock, speed),
    h("div", { class: "row wrap" }, toggles, h("button", { type: "button", id: "frame", onclick: () => player()?.frame() }, "frame the action")),
    motions.length > 1 && h("fieldset", { class: "row" }, h("legend", {}, "engines"), overlay),
  );
  return {
    element,
    update(t, playing) {
      range.value = t;
      clock.textContent = `${t.toFixed(2)} s`;
      const text = playing ? "pause" : "play";
      if (play.textContent !== text) play.textContent = text;
    },
  };
}

function measured(event) {
  return Object.entries(event.measured ?? {})
    .filter(([key, value]) => UNITS[key.slice(key.lastIndexOf("_") + 1)] && key !== "time_s" && Math.abs(value) >= 0.005)
    .map(([key, value]) => quantity(key, value))
    .join(", ");
}

function events(view, player) {
  const verdict = view.data.metrics.verdict;
  if (!verdict?.events?.length) return null;
  return h(
    "div",
    {},
    h("h2", {}, `Events: ${verdict.completed} of ${verdict.n_events}`),
    h(
      "ol",
      { class: "events" },
      verdict.events.map((e) =>
        h(
          "li",
          { class: e.completed ? "" : "failed" },
          e.time_s !== null && e.time_s !== undefined
            ? h("button", { type: "button", class: "time", onclick: () => player()?.seek(e.time_s) }, `${e.time_s.toFixed(2)} s`)
            : h("span", { class: "time" }, "–"),
          h("strong", { title: e.id }, called(e)),
          ` ${e.bodies.map(words).join(", ")} `,
          h("span", { class: "faint" }, e.completed ? measured(e) : `not completed: ${e.reason}`),
        ),
      ),
    ),
  );
}

// Without the signs that tell names from words, and without the value: it stands in the next column.
const plainly = (constraint) => words(constraint.replace(/(^|\s)=(?=\S)/g, "$1").replace(/\s+(=|<=|>=|in)\s.*$/, ""));

const target = (t) => (Array.isArray(t) ? `${number(t[0])} to ${number(t[1])}` : number(t));

function constraints(data) {
  const found = data.metrics.verdict?.constraints ?? [];
  if (!found.length) return null;
  return h(
    "div",
    {},
    h("h2", {}, "Prescribed parameters"),
    h(
      "table",
      { class: "figures" },
      h("thead", {}, h("tr", {}, ["parameter", "asked", "measured", "score"].map((c) => h("th", { scope: "col" }, c)))),
      h(
        "tbody",
        {},
        found.map((c) =>
          h(
            "tr",
            { class: c.score < 1 ? "failed" : "" },
            h("th", { scope: "row", title: c.constraint }, plainly(c.constraint)),
            h("td", { class: "whole" }, `${target(c.target)} ${c.unit}`),
            h("td", { class: "whole", title: c.reason || undefined }, c.measured === null ? "–" : `${number(c.measured)} ${c.unit}`),
            h("td", {}, percent(100 * c.score)),
          ),
        ),
      ),
    ),
  );
}

function engines({ data }) {
  if (data.replays.length < 2) return null;
  const ids = [...new Set(data.replays.flatMap((r) => r.events.map((e) => e.id)))];
  const cell = (r, id) => {
    const e = r.events.find((x) => x.id === id);
    if (!e) return "–";
    return e.completed && e.time_s !== null ? `${e.time_s.toFixed(2)} s` : e.completed ? "done" : "not completed";
  };
  return h(
    "div",
    {},
    h("h2", {}, "Engines"),
    h(
      "div",
      { class: "scroll" },
      h(
        "table",
        { class: "figures" },
        h("thead", {}, h("tr", {}, h("td"), data.replays.map((r) => h("th", { scope: "col" }, `${r.engine} (${r.proof})`)))),
        h("tbody", {}, ids.map((id) => h("tr", {}, h("th", { scope: "row" }, id), data.replays.map((r) => h("td", {}, cell(r, id)))))),
      ),
    ),
  );
}

function graphTabs(data) {
  const parts = [spatialGraph(data.document), timelineGraph(data.document)].filter(Boolean);
  return parts.length ? h("div", {}, parts) : null;
}

function optimizer(data) {
  const r = data.document.dynamics_result;
  if (!r) return null;
  const facts = [
    `strategy ${r.strategy}`,
    r.engine && `engine ${r.engine} at ${Math.round(1 / r.dt_s)} Hz`,
    `${r.evaluations} rollouts`,
    `loss ${number(r.loss)}`,
  ].filter(Boolean);
  return h(
    "div",
    {},
    h("p", { class: "faint" }, facts.join(" · ")),
    r.history.length > 1 ? history(r.history) : r.history.length === 1 && h("p", { class: "faint" }, `The first round was good enough: loss ${number(r.history[0])}.`),
    r.parameters.length > 0 &&
      h(
        "div",
        { class: "scroll" },
        h(
          "table",
          { class: "figures" },
          h("thead", {}, h("tr", {}, ["parameter", "start", "found", "from", "to", "unit"].map((c) => h("th", { scope: "col" }, c)))),
          h(
            "tbody",
            {},
            r.parameters.map((p) =>
              h("tr", {}, h("th", { scope: "row" }, p.name), [p.initial, p.value, p.lower, p.upper].map((v) => h("td", {}, number(v, 4))), h("td", {}, p.fixed ? `${p.unit} fixed` : p.unit)),
            ),
          ),
        ),
      ),
    Object.keys(r.margins).length > 0 &&
      h("p", {}, "Worst margins: ", Object.entries(r.margins).map(([k, v]) => `${words(k)} ${number(v)}`).join(", ")),
    r.relaxed.length > 0 &&
      h("ul", {}, r.relaxed.map((x) => h("li", {}, `${words(x.event)} ${words(x.quantity)}: asked ${target(x.requested)}, reached ${number(x.achieved)} ${x.unit}`))),
  );
}

function history(values) {
  return plots.line({
    title: "loss by round (logarithmic)",
    xs: values.map((_, k) => k),
    ys: values.map((v) => Math.log10(Math.max(v, 1e-9))),
    format: (v) => number(10 ** v, 2),
    unit: "",
  });
}

function sources(data) {
  const names = Object.keys(data.texts).filter((n) => /\.(h|cpp)$/.test(n));
  if (!names.length) return null;
  return h("div", {}, names.map((n) => h("details", {}, h("summary", {}, n), h("pre", { class: "code", tabindex: "0" }, code(data.texts[n])))));
}

// Comments, strings, preprocessor lines and keywords; enough to read the class by.
const TOKENS = /(\/\/[^\n]*|\/\*[\s\S]*?\*\/)|("(?:[^"\\\n]|\\.)*")|(^[ \t]*#[^\n]*)|\b(class|struct|public|private|protected|virtual|override|const|static|constexpr|void|float|double|int32|bool|auto|return|if|else|for|while|namespace|using|true|false|nullptr|new|this)\b/gm;

function code(text) {
  const out = [];
  let at = 0;
  for (const m of text.matchAll(TOKENS)) {
    out.push(text.slice(at, m.index));
    out.push(h("span", { class: m[1] ? "c" : m[2] ? "t" : m[3] ? "p" : "k" }, m[0]));
    at = m.index + m[0].length;
  }
  out.push(text.slice(at));
  return out;
}

function film(data, urls) {
  if (!data.film) return null;
  const url = filmUrl(data.film);
  urls.push(url);
  return h("video", { src: url, class: "film", controls: "", loop: "", muted: "", playsinline: "", preload: "metadata", "aria-label": "Film of the action, slowed down around short events" });
}

function sheet(data, urls) {
  if (!data.sheet) return null;
  const url = imageUrl(data.sheet);
  urls.push(url);
  return h("img", { src: url, class: "sheet", alt: "The scene before, at every completed event, and after", loading: "lazy", decoding: "async" });
}

function stages(data) {
  const rows = data.log.filter((e) => e.stage);
  if (!rows.length) return null;
  return h(
    "div",
    {},
    h(
      "table",
      { class: "figures" },
      h("thead", {}, h("tr", {}, ["stage", "seconds", ""].map((c) => h("th", { scope: "col" }, c)))),
      h("tbody", {}, rows.map((e) => h("tr", {}, h("th", { scope: "row" }, e.stage), h("td", {}, number(e.seconds)), h("td", {}, e.error ?? (e.cached ? "from cache" : ""))))),
    ),
    rows.filter((e) => e.traceback).map((e) => h("pre", { class: "code", tabindex: "0" }, e.traceback)),
  );
}

function downloads(s, data, urls) {
  const inside = { "esg.json": JSON.stringify(data.document, null, 2), "metrics.json": JSON.stringify(data.metrics, null, 2), ...data.texts };
  const save = ([name, text]) => {
    const url = URL.createObjectURL(new Blob([text], { type: "text/plain" }));
    urls.push(url);
    return h("li", {}, h("a", { href: url, download: name }, name), h("span", { class: "faint" }, ` ${bytes(text.length)}`));
  };
  const folder = only() ? index.files : `${index.files}/${s.id}`;
  const beside = data.files.filter(([path]) => !(path.split("/").pop() in inside));
  return h(
    "div",
    { class: "two" },
    h("div", {}, h("h3", {}, "In this page"), h("ul", {}, Object.entries(inside).map(save))),
    beside.length > 0 &&
      h(
        "div",
        {},
        h("h3", {}, "In the scene folder"),
        h("p", { class: "faint" }, index.files ? "These links work where the page lies beside the scene folders." : "These files stay in the scene folder."),
        h(
          "ul",
          {},
          beside.map(([path, size]) =>
            h(
              "li",
              {},
              index.files ? h("a", { href: encodeURI(`${folder}/${path}`).replaceAll("#", "%23"), download: path.split("/").pop() }, path) : path,
              h("span", { class: "faint" }, ` ${bytes(size)}`),
            ),
          ),
        ),
      ),
  );
}

const only = () => index.single === true;
