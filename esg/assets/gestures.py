"""Gestures that the nodes of a document make, and how far they go on what is drawn of them."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np

from esg.assets.appearances import appearances
from esg.assets.configuration import parametric_entry
from esg.assets.library.catalogue import build_sketch
from esg.engines.scene import Gesture
from esg.graph.casting import effective
from esg.graph.models import EsgDocument, Predicate
from esg.lexicon import gestures as table
from esg.lexicon.gestures import EASES, NONE, SWEEPS, State, posed
from esg.lexicon.postures import PLANS
from esg.units import CM_PER_M

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from esg.assets.appearance import Appearance
    from esg.graph.models import AssetConfiguration

TIPS = {"hand_right": ("hand_right", "arm_right", "sleeve_right"), "head": ("head",)}
"""How the names of the parts end or begin of which a row's tip is one; else its own name."""


def plan_of_node(doc: EsgDocument, name: str) -> str | None:
    """The plan of the body that is drawn for a node; None if it makes no gestures."""
    doc = effective(doc)
    node = doc.spatial_relation_graph.nodes.get(name)
    config = None if node is None else doc.asset_configurations.get(node.asset_id)
    entry = None if config is None else parametric_entry(config)
    return None if entry is None else PLANS.get(entry.builder)


def gestures_of(doc: EsgDocument) -> dict[str, tuple[Gesture, ...]]:
    """The gestures of nodes, by their ids, of those that are said to make some.

    Args:
        doc: A resolved document.
    """
    told = [s for s in doc.statements or () if s.predicate is Predicate.GESTURES]
    out: dict[str, tuple[Gesture, ...]] = {}
    for s in told:
        for name in s.object:
            plan = plan_of_node(doc, name)
            row = table.gestures().get((s.noun or "", plan or ""))
            if row is None:
                continue
            first, _, last = s.when.partition("..")
            begins = "" if first in ("start", "throughout") else first
            ends = "" if last in ("end", "") else last
            sweep, rise = _reach(doc, name, row)
            made = Gesture(row.name, row.period_s, row.times, sweep, rise, begins, ends)
            out[name] = (*out.get(name, ()), made)
    return out


def _reach(doc: EsgDocument, name: str, row: table.Gesture) -> tuple[float, float]:
    """How far the tip goes to and fro, and how far its rest is from where it was [m]."""
    doc = effective(doc)
    config = doc.asset_configurations[doc.spatial_relation_graph.nodes[name].asset_id]
    look = appearances(doc)[name]
    own, rest, far = (
        _tip(config, look, row, state) for state in (NONE, (EASES, 0), (EASES, SWEEPS))
    )
    if not len(own):
        return 0.0, 0.0
    sweep = float(np.linalg.norm(far - rest, axis=1).max()) if row.period_s else 0.0
    rise = float(np.linalg.norm(rest - own, axis=1).max())
    return round(sweep / CM_PER_M, 4), round(rise / CM_PER_M, 4)


def _tip(
    config: AssetConfiguration, look: Appearance, row: table.Gesture, state: State
) -> NDArray[np.float64]:
    """Corners of the tip's part [cm], shape [n, 3]."""
    entry = parametric_entry(config)
    assert entry is not None
    look = replace(look, pose=posed(look.pose, row.name, state))
    names = TIPS.get(row.tip, (row.tip,))
    drawn = build_sketch(entry, config.dimensions_cm, config.color_rgb, look).parts
    own = next((p for n in names for p in drawn if p.name.endswith(n)), None)
    return np.zeros((0, 3)) if own is None else np.asarray(own.mesh().vertices, float)
