"""Binds target phrases to regions: pockets, goal mouths, insides, lanes."""

from __future__ import annotations

import numpy as np

from esg.engines.scene import Region, SimScene
from esg.metrics.normalization import normalize
from esg.metrics.phrases import OPPOSITE, Phrase, canonical_modifier
from esg.units import quat_rotate

_CONTAINER_KINDS = ("inside", "goal", "hole", "pocket")
_REGION_HEADS = {
    "pocket": {"pocket", "hole"},
    "hole": {"hole", "pocket", "cup"},
    "goal": {"goal", "net", "mouth"},
    "lane": {"lane", "road", "street"},
    "inside": {"inside", "interior", "basket", "hoop"},
    "area": {"area", "zone", "region", "spot", "space", "circle", "square"},
}


def _region_words(region: Region) -> tuple[str, set[str], set[str]]:
    local = normalize(region.name.split("/")[-1])
    own = {canonical_modifier(w) for w in local.split()}
    parent = {canonical_modifier(w) for w in normalize(region.parent).split()}
    return local, own, parent


def bind_regions(wanted: Phrase, scene: SimScene) -> tuple[int, ...]:
    """Regions whose own name carries the phrase: exact names first, then all words."""
    need = {wanted.head, *wanted.modifiers}
    if wanted.identifier:
        need.add(wanted.identifier)
    exact: list[int] = []
    full: list[int] = []
    with_parent: list[int] = []
    for i, region in enumerate(scene.regions):
        local, own, parent = _region_words(region)
        if local == wanted.text:
            exact.append(i)
        if need <= own:
            full.append(i)
        elif wanted.head in own and need <= own | parent | {region.kind}:
            with_parent.append(i)
    return tuple(exact or full or with_parent)


def loose_regions(wanted: Phrase, scene: SimScene) -> tuple[int, ...]:
    """Regions of the right kind, chosen by position where the phrase states one."""
    kinds = {k for k, heads in _REGION_HEADS.items() if wanted.head in heads}
    found = [
        i
        for i, r in enumerate(scene.regions)
        if r.kind in kinds or wanted.head in _region_words(r)[1]
    ]
    for position in sorted(wanted.positions):
        named = [i for i in found if position in _region_words(scene.regions[i])[1]]
        against = OPPOSITE.get(position, "")
        found = named or [i for i in found if against not in _region_words(scene.regions[i])[1]]
        if named or len(found) <= 1:
            continue
        # Seen by the viewer at +Y: the bottom or front edge is the near one, left is +X.
        axis, sign = {"left": (0, 1), "right": (0, -1), "bottom": (1, 1), "front": (1, 1)}.get(
            position, (1, -1)
        )
        place = {i: sign * _region_center(scene, scene.regions[i])[axis] for i in found}
        spread = max(place.values()) - min(place.values())
        found = [i for i in found if place[i] >= max(place.values()) - 0.2 * spread]
    return tuple(found)


def _region_center(scene: SimScene, region: Region) -> np.ndarray:
    parent = scene.body(region.parent)
    return np.array(parent.position) + quat_rotate(
        np.array(parent.quaternion), np.array(region.center)
    )


def container_regions(scene: SimScene, body: int) -> tuple[int, ...]:
    """Indices of the regions of a body that things can go into (inside, goal, hole, pocket)."""
    name = scene.bodies[body].name
    return tuple(
        i for i, r in enumerate(scene.regions) if r.parent == name and r.kind in _CONTAINER_KINDS
    )
