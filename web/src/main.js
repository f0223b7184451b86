// Routes between the overview and the page of one scene; keys that work everywhere.
import { index, licenses } from "./data.js";
import { detail } from "./detail.js";
import { h } from "./dom.js";
import { matching, overview } from "./list.js";

const app = document.getElementById("app");
const main = h("main", { id: "main", tabindex: "-1" });
const only = index.scenes.length === 1;
let list = null;
let listScroll = 0;
let open = null;

const KEYS = [
  ["/", "search"],
  ["[ and ]", "previous and next scene of the list"],
  ["Escape", "back to the list"],
  ["Space", "play or pause"],
  [", and .", "one frame back or on"],
  ["n and p", "next and previous event"],
  ["f", "frame the action"],
];

function footer() {
  const notices = h("pre", { class: "scroll" });
  return h(
    "footer",
    {},
    h("details", {}, h("summary", {}, "Keys"), h("dl", { class: "keys" }, KEYS.map(([k, what]) => [h("dt", {}, k), h("dd", {}, what)]))),
    h(
      "details",
      {
        ontoggle: () => {
          notices.textContent ||= licenses();
        },
      },
      h("summary", {}, "Licenses of the libraries in this page"),
      notices,
    ),
    h("p", { class: "faint" }, `esg ${index.version}`),
  );
}

const link = (s) => `#/scene/${encodeURIComponent(s.id)}`;

async function route() {
  const wanted = /^#\/scene\/(.+)$/.exec(location.hash);
  let s = only ? index.scenes[0] : null;
  if (wanted) s = index.scenes.find((x) => x.id === safeDecode(wanted[1])) ?? s;
  open?.dispose();
  open = null;
  if (!s) {
    list ??= overview();
    main.replaceChildren(list);
    document.title = index.title;
    window.scrollTo(0, listScroll);
    return;
  }
  document.title = `${s.id} – ${index.title}`;
  const order = matching();
  const at = order.findIndex((x) => x.n === s.n);
  const navigation = only
    ? null
    : h(
        "nav",
        { class: "row", "aria-label": "Scenes" },
        h("a", { href: "#/", id: "back" }, "← all scenes"),
        h("span", { class: "grow" }),
        at > 0 && h("a", { href: link(order[at - 1]), id: "previous" }, "previous"),
        at >= 0 && at + 1 < order.length && h("a", { href: link(order[at + 1]), id: "next" }, "next"),
      );
  const page = await detail(s);
  open = page;
  main.replaceChildren(...[navigation, page.element].filter(Boolean));
  window.scrollTo(0, 0);
  if (window.parent === window) main.focus({ preventScroll: true }); // inside another page somebody may be typing there
  page.shown();
}

function safeDecode(text) {
  try {
    return decodeURIComponent(text);
  } catch {
    return text;
  }
}

document.addEventListener("keydown", (e) => {
  if (e.ctrlKey || e.metaKey || e.altKey) return;
  const select = e.target.tagName === "SELECT";
  const typing = select || (e.target.tagName === "INPUT" && e.target.type === "search");
  if (e.key === "Escape") {
    if (typing) e.target.blur();
    else if (open && !only) location.hash = "#/";
    return;
  }
  if (typing && !(select && e.key === "/")) return;
  if (e.key === "/") {
    const search = document.getElementById("search");
    if (search) {
      e.preventDefault();
      search.focus();
    }
  } else if (e.key === "[") document.getElementById("previous")?.click();
  else if (e.key === "]") document.getElementById("next")?.click();
  else if (open?.key(e.key, e.target)) e.preventDefault();
});

window.addEventListener("scroll", () => {
  if (!open && list) listScroll = window.scrollY;
});
window.addEventListener("hashchange", route);
app.replaceChildren(main, footer());
route().then(() => document.documentElement.setAttribute("data-ready", "yes"));
