// The overview: figures of the run, filters, and a card for every scene.
import { index, thumbnail } from "./data.js";
import { badge, breakable, called, h, number, percent, words } from "./dom.js";

const state = { text: "", outcome: "", event: "", problem: "", sort: "order", down: false };

const eventsShare = (s) => (s.n_events ? s.completed / s.n_events : 1);
const coverage = (s) => (s.items ? s.used / s.items : 0);

const SORTS = {
  order: ["order of the run", (s) => s.n],
  outcome: ["outcome", (s) => s.outcome],
  events: ["events completed", eventsShare],
  ppa: ["parameter accuracy", (s) => s.ppa ?? 2],
  coverage: ["coverage", coverage],
  seconds: ["time spent", (s) => s.seconds],
  objects: ["objects", (s) => s.objects],
};

const PROBLEMS = {
  "": ["anything", () => true],
  events: ["events not completed", (s) => s.completed < s.n_events],
  layout: ["invalid layout", (s) => s.slr === false],
  parameters: ["parameters off", (s) => s.ppa !== null && s.ppa < 1],
  files: ["damaged files", (s) => s.problems.length > 0],
  words: ["words not understood", (s) => s.not_understood.length > 0],
  said: ["words not shown", (s) => s.not_kept.length > 0],
  implausible: ["not plausible", (s) => s.plausible === false],
};

export function summary() {
  const { totals: t, paper, before, facts } = index;
  const p = paper.totals;
  const columns = [["this run", t]];
  if (before.events !== undefined) columns.push(["last run", before]);
  if (p) {
    columns.push([
      "paper",
      {
        events: p.events,
        ecr_mean: p.ecr.paper[0],
        ecr_std: p.ecr.paper[1],
        slr: p.slr.paper[0],
        ppa: p.ppa.paper,
        seconds_per_scene: p.seconds_per_scene.paper,
      },
    ]);
  }
  const rows = [
    ["Events completed", (c) => (c.events ? `${number(c.ecr_mean)} ± ${number(c.ecr_std, 2)} of ${c.events}` : "no events")],
    ["Scene layout rate", (c) => percent(c.slr)],
    ["Parameter accuracy", (c) => percent(c.ppa)],
    ["Plausible", (c) => percent(c.plausible)],
    ["Time a scene", (c) => `${number(c.seconds_per_scene)} s`],
  ];
  const ended = new Map();
  for (const s of index.scenes) ended.set(s.outcome, (ended.get(s.outcome) ?? 0) + 1);
  const damaged = index.scenes.filter((s) => s.problems.length).length;
  const about = ["suite", "strategy", "engine", "runs"].filter((k) => facts[k] !== undefined);
  return h(
    "section",
    { class: "summary", "aria-label": "Summary" },
    h("h1", {}, index.title),
    h(
      "p",
      { class: "faint" },
      `${index.scenes.length} scenes`,
      about.map((k) => ` · ${k} ${facts[k]}`),
      before.name ? ` · last run: ${before.name}` : "",
    ),
    h(
      "p",
      { class: "row wrap", id: "outcomes" },
      [...ended].sort((a, b) => b[1] - a[1] || (a[0] < b[0] ? -1 : 1)).map(([o, n]) => h("span", {}, `${n} `, badge(o))),
    ),
    index.problems.map((p) => h("p", { class: "warn" }, p)),
    damaged
      ? h("p", { class: "warn" }, `${damaged} of ${index.scenes.length} scenes have damaged files; without its verdict a scene counts as having none of its events`)
      : null,
    h(
      "table",
      { class: "figures" },
      h("thead", {}, h("tr", {}, h("td"), columns.map(([name]) => h("th", { scope: "col" }, name)))),
      h(
        "tbody",
        {},
        rows.map(([name, show]) =>
          h("tr", {}, h("th", { scope: "row" }, name), columns.map(([, c]) => h("td", {}, show(c)))),
        ),
      ),
    ),
    perScene(),
  );
}

function perScene() {
  if (index.rows.length < 2 || index.rows.length === index.scenes.length && !index.paper.completion) return null;
  const methods = index.paper.completion ? index.paper.methods : [];
  const mean = (v) => v.reduce((a, b) => a + b, 0) / v.length;
  return h(
    "details",
    {},
    h("summary", {}, "Events completed, scene by scene"),
    h(
      "div",
      { class: "scroll" },
      h(
        "table",
        { class: "figures" },
        h(
          "thead",
          {},
          h(
            "tr",
            {},
            ["scene", "events", "this run", ...methods.map((m) => index.paper.method_names[m])].map((c) =>
              h("th", { scope: "col" }, c),
            ),
          ),
        ),
        h(
          "tbody",
          {},
          index.rows.map((row) =>
            h(
              "tr",
              {},
              h("th", { scope: "row" }, row.id),
              h("td", {}, row.n_events),
              h("td", {}, number(mean(row.completed))),
              methods.map((m) => h("td", {}, number(index.paper.completion[row.id]?.[m]?.[0]))),
            ),
          ),
        ),
      ),
    ),
  );
}

export function overview() {
  const grid = h("ul", { class: "cards", id: "cards", "aria-label": "Scenes" });
  const cards = index.scenes.map(card);
  const count = h("p", { class: "faint", role: "status", id: "count" });
  const types = [...new Set(index.scenes.flatMap((s) => s.events.map((e) => e.type)))].sort();
  const outcomes = [...new Set(index.scenes.map((s) => s.outcome))].sort();

  const show = () => {
    const wanted = matching();
    for (const item of cards) item.hidden = true;
    for (const s of wanted) {
      cards[s.n].hidden = false;
      grid.append(cards[s.n]);
    }
    count.textContent = `${wanted.length} of ${index.scenes.length} scenes`;
  };
  const choose = (key, label, options) =>
    h(
      "label",
      {},
      label,
      h(
        "select",
        {
          id: `filter-${key}`,
          onchange: (e) => {
            state[key] = e.target.value;
            show();
          },
        },
        options.map(([value, text]) => h("option", { value, selected: state[key] === value }, text)),
      ),
    );
  const direction = h(
    "button",
    {
      type: "button",
      id: "direction",
      "aria-pressed": state.down,
      onclick: () => {
        state.down = !state.down;
        direction.setAttribute("aria-pressed", state.down);
        show();
      },
    },
    "reverse",
  );
  const search = h("input", {
    type: "search",
    id: "search",
    placeholder: "prompt, name or reason ( / )",
    value: state.text,
    oninput: (e) => {
      state.text = e.target.value;
      show();
    },
  });
  const filters = h(
    "form",
    { class: "filters", role: "search", onsubmit: (e) => e.preventDefault() },
    h("label", {}, "search", search),
    choose("outcome", "outcome", [["", "any"], ...outcomes.map((o) => [o, words(o)])]),
    choose("event", "event", [["", "any"], ...types.map((t) => [t, words(t)])]),
    choose("problem", "show", Object.entries(PROBLEMS).map(([k, [text]]) => [k, text])),
    choose("sort", "sort by", Object.entries(SORTS).map(([k, [text]]) => [k, text])),
    direction,
  );
  grid.append(...cards);
  show();
  watch(cards);
  return h("div", {}, summary(), filters, count, grid);
}

export function matching() {
  const text = state.text.trim().toLowerCase();
  const found = index.scenes.filter(
    (s) =>
      (!text || `${s.id} ${s.prompt} ${s.reason}`.toLowerCase().includes(text)) &&
      (!state.outcome || s.outcome === state.outcome) &&
      (!state.event || s.events.some((e) => e.type === state.event)) &&
      PROBLEMS[state.problem][1](s),
  );
  const key = SORTS[state.sort][1];
  const sign = state.down ? -1 : 1;
  return found.sort((a, b) => {
    const x = key(a);
    const y = key(b);
    return (x < y ? -1 : x > y ? 1 : 0) * sign || a.n - b.n;
  });
}

function card(s) {
  const facts = [];
  if (s.n_events) facts.push(`${s.completed}/${s.n_events} events`);
  if (s.slr !== null && s.slr !== undefined) facts.push(s.slr ? "layout valid" : "layout INVALID");
  if (s.ppa !== null) facts.push(`parameters ${percent(100 * s.ppa)}`);
  if (s.statements) facts.push(`${s.kept}/${s.statements} statements kept`);
  if (s.plausible !== null) facts.push(s.plausible ? "plausible" : "NOT PLAUSIBLE");
  if (s.items) facts.push(`${s.used}/${s.items} words used`);
  facts.push(`${number(s.seconds, 2)} s`);
  const lost = s.not_kept.map((x) => x.words);
  const nouns = s.not_understood.filter((text) => !lost.includes(text));
  const missing = [
    s.not_kept.length > 0 && h("p", { class: "warn" }, s.not_kept.map((x) => `${words(x.status)}: “${x.words}”`).join("; ")),
    s.implausible && h("p", { class: "warn" }, `implausible: ${s.implausible}`),
    nouns.length > 0 && h("p", { class: "warn" }, `not understood: ${nouns.join(", ")}`),
  ];
  const failed = s.events.filter((e) => !e.completed);
  return h(
    "li",
    { "data-n": s.n },
    h(
      "a",
      { class: "card", href: `#/scene/${encodeURIComponent(s.id)}` },
      h("div", { class: "thumb" }, h("span", { class: "faint" }, "no picture")),
      h("div", { class: "row" }, h("strong", {}, breakable(s.id)), badge(s.outcome)),
      h("p", { class: "prompt" }, s.prompt),
      h("p", { class: "faint" }, facts.join(" · ")),
      missing,
      s.problems.map((p) => h("p", { class: "warn" }, p)),
      failed.length && !["solved", "partial"].includes(s.outcome)
        ? h("p", { class: "warn" }, failed.map((e) => `${called(e)}: ${e.reason}`).join("; "))
        : s.reason && !["solved", "partial"].includes(s.outcome)
          ? h("p", { class: "warn" }, s.reason)
          : null,
    ),
  );
}

// Pictures are decoded when their card comes near the window, and let go when it leaves.
function watch(cards) {
  const seen = new IntersectionObserver(
    (entries) => {
      for (const { target, isIntersecting } of entries) {
        const place = target.querySelector(".thumb");
        const image = place.querySelector("img");
        if (isIntersecting && !image) {
          const url = thumbnail(Number(target.dataset.n));
          if (url) place.replaceChildren(h("img", { src: url, alt: "", decoding: "async" }));
        } else if (!isIntersecting && image) {
          URL.revokeObjectURL(image.src);
          image.remove();
        }
      }
    },
    { rootMargin: "400px" },
  );
  for (const item of cards) seen.observe(item);
}
