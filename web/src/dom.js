// Elements from plain data. Text only ever becomes text nodes: nothing is parsed as markup.

const SVG = "http://www.w3.org/2000/svg";

function fill(element, attributes, children) {
  for (const [key, value] of Object.entries(attributes ?? {})) {
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

export function h(name, attributes, ...children) {
  return fill(document.createElement(name), attributes, children);
}

export function s(name, attributes, ...children) {
  return fill(document.createElementNS(SVG, name), attributes, children);
}

export function number(value, digits = 3) {
  if (value === null || value === undefined || !Number.isFinite(value)) return "–";
  if (value === 0) return "0";
  return Math.abs(value) >= 100 ? value.toFixed(0) : String(Number(value.toPrecision(digits)));
}

export function percent(value, digits = 0) {
  return value === null || value === undefined ? "–" : `${value.toFixed(digits)}%`;
}

export function bytes(count) {
  if (count < 1000) return `${count} B`;
  return count < 1e6 ? `${(count / 1e3).toFixed(0)} kB` : `${(count / 1e6).toFixed(1)} MB`;
}

export const words = (text) => String(text ?? "").replaceAll("_", " ");

const OUTCOMES = {
  solved: "good",
  partial: "fair",
  nearest_feasible: "fair",
  infeasible: "fair",
  not_converged: "bad",
  invalid_draft: "bad",
  crashed: "bad",
};

export function badge(outcome) {
  return h("span", { class: `badge ${OUTCOMES[outcome] ?? "bad"}` }, words(outcome));
}

// A name that may break after its underscores and hyphens, and is copied as it is.
export const breakable = (name) => String(name).split(/(?<=[_-])/).flatMap((part) => [part, h("wbr")]).slice(0, -1);

// An event as people call it: its name, unless that only repeats its type (beside it stands who).
export function called(e) {
  const made = e.id === e.type || e.id.endsWith(`_${e.type}`) || e.bodies?.length && e.bodies.every((b) => e.id.includes(b));
  return made ? words(e.type) : `${e.id} ${words(e.type)}`;
}
