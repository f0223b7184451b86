"""The parts of which models are drawn, of those of whom it is stated what they wear."""

from __future__ import annotations

from esg.assets.appearances import appearances
from esg.assets.configuration import parametric_entry
from esg.assets.library.catalogue import build_sketch
from esg.graph.casting import effective
from esg.graph.models import EsgDocument, Predicate

_TOLD = (Predicate.WEARS, Predicate.LOOKS)


def drawn_parts(doc: EsgDocument) -> dict[str, tuple[str, ...]]:
    """Names, colours and materials of the parts that are drawn, by the id of a node.

    Args:
        doc: A resolved document.

    Returns:
        "NAME #rrggbb MATERIAL" of every part, each once, in the order of the drawing; nothing of
        models that no builder draws, and of nodes without statements of what they wear.
    """
    told = {name for s in doc.statements or () if s.predicate in _TOLD for name in s.object}
    if not told:
        return {}
    doc = effective(doc)
    looks, nodes = appearances(doc), doc.spatial_relation_graph.nodes
    out: dict[str, tuple[str, ...]] = {}
    for name in sorted(told & {*nodes}):
        config = doc.asset_configurations[nodes[name].asset_id]
        entry = parametric_entry(config)
        if entry is not None:
            parts = build_sketch(entry, config.dimensions_cm, config.color_rgb, looks[name]).parts
            listed = (f"{p.name} {_hex(p.color)} {p.material}" for p in parts)
            out[name] = tuple(dict.fromkeys(listed))
    return out


def _hex(color: tuple[float, float, float]) -> str:
    return "#" + "".join(f"{min(255, max(0, round(255 * c))):02x}" for c in color)
