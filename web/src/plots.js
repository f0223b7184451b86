// Speeds and distances over time, with event markers and the windows of prescribed values.
import { h, number, s as svg, words } from "./dom.js";

const W = 560;
const H = 210;
const PAD = { left: 46, right: 12, top: 24, bottom: 26 };
const TOLERANCE = { s: 0.3, "m/s": 1, kg: 0.5, m: 0.1, deg: 5 };
const MAX_LINES = 6;

export function plots(view, seek) {
  const { data, motions, s } = view;
  const motion = motions[0];
  const cast = participants(view);
  const speeds = cast.filter((b) => motion.column.has(b)).slice(0, MAX_LINES);
  const pairs = pairsOf(view).slice(0, MAX_LINES);
  const windows = windowsOf(data);
  const charts = [];
  if (speeds.length) {
    charts.push(
      chart({
        title: "speed",
        unit: "m/s",
        time: motion.time,
        lines: speeds.map((b) => ({ name: view.names[b], ys: series(motion, (f) => motion.speed(b, f)) })),
        bands: windows.speed,
        moments: windows.time,
        events: s.events,
        seek,
      }),
    );
  }
  if (pairs.length) {
    charts.push(
      chart({
        title: "distance between centres",
        unit: "m",
        time: motion.time,
        lines: pairs.map(([a, b]) => ({
          name: `${view.names[a]} – ${view.names[b]}`,
          ys: series(motion, (f) => {
            const p = motion.center(a, f);
            const q = motion.center(b, f);
            return Math.hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
          }),
        })),
        bands: [],
        moments: windows.time,
        events: s.events,
        seek,
      }),
    );
  }
  if (windows.distance.length && speeds.length) {
    charts.push(
      chart({
        title: "distance travelled",
        unit: "m",
        time: motion.time,
        lines: speeds.map((b) => ({ name: view.names[b], ys: travelled(motion, b) })),
        bands: windows.distance,
        moments: windows.time,
        events: s.events,
        seek,
      }),
    );
  }
  return {
    element: h("div", { class: "plots" }, charts.map((c) => c.element)),
    update(t) {
      for (const c of charts) c.update(t);
    },
  };
}

plots.line = ({ title, xs, ys, format, unit }) =>
  chart({ title, unit, time: Float32Array.from(xs), lines: [{ name: title, ys: Float32Array.from(ys) }], bands: [], moments: [], events: [], seek: null, format }).element;

function series(motion, value) {
  const out = new Float32Array(motion.time.length);
  for (let f = 0; f < out.length; f++) out[f] = value(f);
  return out;
}

function travelled(motion, body) {
  const out = new Float32Array(motion.time.length);
  for (let f = 1; f < out.length; f++) {
    const a = motion.center(body, f - 1);
    const b = motion.center(body, f);
    out[f] = out[f - 1] + Math.hypot(b[0] - a[0], b[1] - a[1]);
  }
  return out;
}

function participants({ data, motions, s }) {
  const names = new Set(s.events.flatMap((e) => e.bodies ?? []));
  const found = data.bodies.map((b, i) => (names.has(b.name) ? i : -1)).filter((i) => i >= 0);
  return found.length ? found : motions[0].moving;
}

function pairsOf({ data, motions, s }) {
  const index = new Map(data.bodies.map((b, i) => [b.name, i]));
  const seen = new Map();
  for (const e of s.events) {
    const [a, b] = (e.bodies ?? []).map((n) => index.get(n)).filter((i) => i !== undefined);
    if (a === undefined || b === undefined || a === b) continue;
    if (motions[0].column.has(a) || motions[0].column.has(b)) seen.set(`${Math.min(a, b)},${Math.max(a, b)}`, [a, b]);
  }
  return [...seen.values()];
}

// Prescribed values as bands: of speed, of distance travelled, and of time.
function windowsOf(data) {
  const out = { speed: [], distance: [], time: [] };
  for (const c of data.metrics.verdict?.constraints ?? []) {
    const tolerance = TOLERANCE[c.unit] ?? 0;
    const [low, high] = Array.isArray(c.target) ? c.target : [c.target - tolerance, c.target + tolerance];
    const band = { low, high, text: c.constraint, good: c.score >= 1 };
    if (c.quantity.startsWith("speed")) out.speed.push(band);
    else if (c.quantity === "distance") out.distance.push(band);
    else if (c.quantity === "time") out.time.push(band);
    else if (c.quantity === "time_since") {
      // Counted from an event: shown from where that event was.
      const since = /\bsince (\S+)/.exec(c.constraint)?.[1];
      const from = since === "start" ? 0 : data.metrics.verdict.events.find((e) => e.id === since)?.time_s;
      if (from !== null && from !== undefined) out.time.push({ ...band, low: from + low, high: from + high });
    }
  }
  const nodes = data.document.timeline_system?.sequence_graph?.nodes ?? [];
  for (const n of nodes) {
    if (n.window && n.time_is_prescribed) out.time.push({ low: n.window[0], high: n.window[1], text: `window of ${words(n.id)}`, good: true });
  }
  return out;
}

function chart({ title, unit, time, lines, bands, moments, events, seek, format = (v) => number(v) }) {
  const end = time[time.length - 1] || 1;
  let low = Math.min(0, ...lines.map((l) => Math.min(...l.ys)));
  let high = Math.max(...lines.map((l) => Math.max(...l.ys)), ...bands.map((b) => b.high));
  if (seek === null) low = Math.min(...lines.map((l) => Math.min(...l.ys)));
  if (!(high > low)) high = low + 1;
  const x = (t) => PAD.left + ((W - PAD.left - PAD.right) * t) / end;
  const y = (v) => H - PAD.bottom - ((H - PAD.top - PAD.bottom) * (v - low)) / (high - low);
  const clamp = (t) => Math.min(end, Math.max(0, t));
  const cursor = svg("line", { class: "cursor", x1: x(0), x2: x(0), y1: PAD.top, y2: H - PAD.bottom });
  const values = h("figcaption", { class: "legend" });
  const keys = lines.map((line, k) => {
    const value = h("output", {}, "");
    values.append(h("span", {}, h("i", { class: `line-${k}` }), line.name, " ", value));
    return value;
  });
  const picture = svg(
    "svg",
    {
      viewBox: `0 0 ${W} ${H}`,
      role: "img",
      "aria-label": `${title}${unit ? ` in ${unit}` : ""} over time: ${lines.map((l) => `${l.name}, at most ${format(Math.max(...l.ys))}`).join("; ")}`,
    },
    moments.map((b) => svg("rect", { class: `band ${b.good ? "good" : "bad"}`, x: x(clamp(b.low)), width: Math.max(1, x(clamp(b.high)) - x(clamp(b.low))), y: PAD.top, height: H - PAD.top - PAD.bottom }, svg("title", {}, b.text))),
    bands.map((b) => svg("rect", { class: `band ${b.good ? "good" : "bad"}`, x: PAD.left, width: W - PAD.left - PAD.right, y: y(b.high), height: Math.max(1, y(Math.max(low, b.low)) - y(b.high)) }, svg("title", {}, b.text))),
    ticks(low, high, 4).map((v) => [
      svg("line", { class: "grid", x1: PAD.left, x2: W - PAD.right, y1: y(v), y2: y(v) }),
      svg("text", { x: PAD.left - 6, y: y(v) + 4, "text-anchor": "end" }, format(v)),
    ]),
    ticks(0, end, 6).map((t) => svg("text", { x: x(t), y: H - 8, "text-anchor": "middle" }, number(t))),
    svg("text", { x: W - PAD.right, y: PAD.top - 9, "text-anchor": "end", class: "title" }, unit ? `${title} [${unit}]` : title),
    lines.map((line, k) => svg("path", { class: `line line-${k}`, d: path(time, line.ys, x, y) })),
    events
      .filter((e) => e.time_s !== null && e.time_s !== undefined)
      .map((e) =>
        svg("line", { class: `moment ${e.completed ? "good" : "bad"}`, x1: x(e.time_s), x2: x(e.time_s), y1: PAD.top, y2: H - PAD.bottom }, svg("title", {}, `${e.id} ${e.type} at ${e.time_s.toFixed(2)} s`)),
      ),
    seek && cursor,
  );
  if (seek) {
    const go = (e) => {
      const box = picture.getBoundingClientRect();
      const at = ((e.clientX - box.left) / box.width) * W;
      seek(clamp(((at - PAD.left) / (W - PAD.left - PAD.right)) * end));
    };
    picture.addEventListener("pointerdown", (e) => {
      picture.setPointerCapture(e.pointerId);
      go(e);
    });
    picture.addEventListener("pointermove", (e) => e.buttons && go(e));
  }
  return {
    element: h("figure", { class: "plot" }, picture, values),
    update(t) {
      cursor.setAttribute("x1", x(clamp(t)));
      cursor.setAttribute("x2", x(clamp(t)));
      let f = 0;
      while (f + 1 < time.length && time[f + 1] <= t) f++;
      lines.forEach((line, k) => (keys[k].textContent = `${format(line.ys[f])} ${unit}`));
    },
  };
}

function path(time, ys, x, y) {
  let d = "";
  for (let f = 0; f < time.length; f++) d += `${f ? "L" : "M"}${x(time[f]).toFixed(1)} ${y(ys[f]).toFixed(1)}`;
  return d;
}

function ticks(low, high, count) {
  const raw = (high - low) / count;
  const power = 10 ** Math.floor(Math.log10(raw));
  const step = [1, 2, 5, 10].map((k) => k * power).find((k) => k >= raw);
  const out = [];
  for (let v = Math.ceil(low / step) * step; v <= high + 1e-9; v += step) out.push(Math.abs(v) < step * 1e-6 ? 0 : v);
  return out;
}
