"""Gestures that the nodes of a document make, and how far they go on what is drawn of them."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np

from esg.assets.appearances import appearances
from esg.assets.postures import plan_drawn
from esg.assets.shows import since, sketched
from esg.engines.scene import Gesture
from esg.graph.casting import effective
from esg.graph.models import EsgDocument, Predicate
from esg.lexicon import gestures as table
from esg.lexicon.gestures import EASES, NONE, SWEEPS, State, posed
from esg.units import CM_PER_M

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from esg.assets.appearance import Appearance

TIPS = {"hand_right": ("hand_right", "arm_right", "sleeve_right"), "head": ("head",)}
"""How the names of the parts end or begin of which a row's tip is one; else its own name."""


def gestures_of(doc: EsgDocument) -> dict[str, tuple[Gesture, ...]]:
    """The gestures of nodes, by their ids, of those that are said to make some.

    Args:
        doc: A resolved document.
    """
    told = [s for s in doc.statements or () if s.predicate is Predicate.GESTURES]
    if not told:
        return {}
    doc = effective(doc)
    looks = appearances(doc)
    out: dict[str, tuple[Gesture, ...]] = {}
    for s in told:
        last = s.when.partition("..")[2]
        times = since(s), "" if last == "end" else last
        for name in s.object:
            row = table.gestures().get((s.noun or "", plan_drawn(doc, name) or ""))
            if row is not None:
                reach = _reach(doc, name, looks[name], row)
                made = Gesture(row.name, row.period_s, row.times, *reach, *times)
                out[name] = (*out.get(name, ()), made)
    return out


def _reach(
    doc: EsgDocument, name: str, look: Appearance, row: table.Gesture
) -> tuple[float, float]:
    """How far the tip goes to and fro, and how far its rest is from where it was [m]."""

    def tip(state: State) -> NDArray[np.float64]:
        """Corners of the tip's part [cm], shape [n, 3]."""
        drawn = sketched(doc, name, replace(look, pose=posed(look.pose, row.name, state)))
        names = TIPS.get(row.tip, (row.tip,))
        own = next((p for n in names for p in drawn if p.name.endswith(n)), None)
        return np.zeros((0, 3)) if own is None else np.asarray(own.mesh().vertices, float)

    own, rest, far = (tip(state) for state in (NONE, (EASES, 0), (EASES, SWEEPS)))
    if not len(own):
        return 0.0, 0.0
    sweep = float(np.linalg.norm(far - rest, axis=1).max()) if row.period_s else 0.0
    rise = float(np.linalg.norm(rest - own, axis=1).max())
    return round(sweep / CM_PER_M, 4), round(rise / CM_PER_M, 4)
