// The evolutive scene graph as two drawings: where things are, and what happens when.
import { Graph, layout } from "@dagrejs/dagre";
import { h, number, s as svg, words } from "./dom.js";

const CHAR = 6.7;

export function spatialGraph(document) {
  const spatial = document.spatial_relation_graph;
  const names = Object.keys(spatial?.nodes ?? {});
  if (!names.length) return null;
  const graph = create("LR");
  for (const name of names) {
    const n = spatial.nodes[name];
    const asset = document.asset_configurations?.[n.asset_id];
    add(graph, name, [n.label || words(name), asset ? `${words(asset.category)}, ${number(asset.mass_kg)} kg` : n.asset_id], n.is_structural ? "structure" : n.mentioned ? "object" : "added");
  }
  for (const e of spatial.edges?.binary_relations ?? []) {
    // A default, and no wish: what nothing turns faces the front.
    if (e.relation_type === "face" && e.confidence <= 0.5) continue;
    if (graph.hasNode(e.from) && graph.hasNode(e.to)) connect(graph, e.from, e.to, words(e.relation_type));
  }
  (spatial.edges?.multi_relations ?? []).forEach((m, k) => {
    const id = `multi relation ${k}`;
    add(graph, id, [words(m.relation_type)], "relation");
    for (const x of m.subjects) if (graph.hasNode(x)) connect(graph, x, id, "");
    for (const x of m.targets) if (graph.hasNode(x)) connect(graph, id, x, "");
  });
  return figure("Where things are", graph);
}

export function timelineGraph(document) {
  const sequence = document.timeline_system?.sequence_graph;
  if (!sequence?.nodes?.length) return null;
  const graph = create("LR");
  for (const n of sequence.nodes) {
    const when = n.timestamp !== null && n.timestamp !== undefined ? `at ${number(n.timestamp)} s` : n.window ? `${number(n.window[0])} to ${number(n.window[1])} s` : "";
    add(graph, n.id, [n.event, n.participants.map(words).join(", ") || n.description, when].filter(Boolean), "event");
  }
  for (const e of sequence.edges) {
    if (!graph.hasNode(e.from) || !graph.hasNode(e.to)) continue;
    connect(graph, e.from, e.to, `${words(e.actor)}: ${e.event}`);
  }
  return figure("What happens when", graph);
}

function create(direction) {
  const graph = new Graph({ multigraph: true });
  graph.setGraph({ rankdir: direction, nodesep: 18, ranksep: 46, edgesep: 12, marginx: 8, marginy: 8 });
  graph.setDefaultEdgeLabel(() => ({}));
  return graph;
}

const shorten = (text) => (text.length > 34 ? `${text.slice(0, 33)}…` : text);

function add(graph, id, lines, kind) {
  const shown = lines.map(shorten);
  graph.setNode(id, { lines: shown, kind, full: lines.join("\n"), width: 22 + CHAR * Math.max(...shown.map((l) => l.length)), height: 14 + 15 * shown.length });
}

let edges = 0;

function connect(graph, from, to, text) {
  const label = shorten(text);
  graph.setEdge(from, to, { text: label, width: label ? CHAR * label.length + 8 : 0, height: label ? 14 : 0, labelpos: "c" }, `e${edges++}`);
}

function figure(title, graph) {
  layout(graph);
  const { width, height } = graph.graph();
  const marker = `arrow${edges++}`;
  const drawing = svg(
    "svg",
    { viewBox: `0 0 ${Math.ceil(width)} ${Math.ceil(height)}`, width: Math.ceil(width), height: Math.ceil(height), role: "img", "aria-label": description(title, graph) },
    svg("defs", {}, svg("marker", { id: marker, viewBox: "0 0 8 8", refX: 7, refY: 4, markerWidth: 7, markerHeight: 7, orient: "auto" }, svg("path", { d: "M0 0L8 4L0 8z", class: "arrow" }))),
    graph.edges().map((e) => {
      const edge = graph.edge(e);
      const d = edge.points.map((p, k) => `${k ? "L" : "M"}${p.x.toFixed(1)} ${p.y.toFixed(1)}`).join("");
      return [svg("path", { class: "edge", d, "marker-end": `url(#${marker})` }), edge.text && svg("text", { class: "edge-text", x: edge.x, y: edge.y + 4, "text-anchor": "middle" }, edge.text)];
    }),
    graph.nodes().map((id) => {
      const n = graph.node(id);
      return svg(
        "g",
        { class: `node ${n.kind}`, transform: `translate(${n.x.toFixed(1)} ${n.y.toFixed(1)})` },
        svg("title", {}, n.full),
        svg("rect", { x: -n.width / 2, y: -n.height / 2, width: n.width, height: n.height, rx: 6 }),
        n.lines.map((line, k) => svg("text", { y: 15 * (k - (n.lines.length - 1) / 2) + 4, "text-anchor": "middle", class: k ? "faint" : "" }, line)),
      );
    }),
  );
  return h("figure", {}, h("figcaption", {}, title), h("div", { class: "scroll", tabindex: "0" }, drawing));
}

function description(title, graph) {
  const links = graph.edges().map((e) => `${words(e.v)} ${graph.edge(e).text} ${words(e.w)}`);
  return `${title}: ${graph.nodes().map(words).join(", ")}. ${links.join("; ")}`;
}
