"""Parts of jointed things: they have the mounts that the table names, and fit each other."""

from __future__ import annotations

import itertools

import numpy as np
import pytest

from esg.assets.geometry.massprops import mass_properties
from esg.assets.library.catalogue import build_sketch, catalogue, parts
from esg.assets.stage import configure
from esg.graph.joints import child_frame, mount_of
from esg.graph.models import AssetConfiguration, AssetRequirement, Joint
from esg.layout.judge.check import prim_penetration
from esg.layout.problem.joined import posed
from esg.layout.problem.shapes import footprints
from esg.lexicon.articulations import Articulation, articulations

ROWS = list(dict.fromkeys(articulations().values()))
SLACK_CM = 3.0
"""Round and slanted shapes are compared by upright boxes around them."""


def configured(name: str, factor: float = 1.0) -> AssetConfiguration:
    entry = parts()[name.replace(" ", "_")]
    size = tuple(factor * d for d in entry.dimensions_cm)
    return configure(
        entry.name,
        AssetRequirement(
            asset_category=entry.name,
            asset_description=entry.description,
            expected_dimensions_cm=size,  # type: ignore[arg-type]
            expected_mass_kg=factor**3 * entry.mass_kg,
            dimensions_are_prescribed=True,
        ),
    )


def sides(row: Articulation) -> tuple[str, str]:
    """Parent and child of a row."""
    ends = (row.becomes, row.with_part)
    return ends if row.carries == "becomes" else (ends[1], ends[0])


def joint(row: Articulation, n: int, position: float = 0.0, factor: float = 1.0) -> Joint:
    long = factor if row.kind in ("rope", "slider") else 1.0
    return Joint(
        id="j", kind=row.kind, child="c", child_mount=row.child_mount, parent="p",
        parent_mount=row.parent_mount.format(n=n), position=position,
        upper=None if row.upper is None else long * row.upper,
    )  # fmt: skip


@pytest.mark.parametrize("row", ROWS, ids=lambda r: r.nouns[0])
@pytest.mark.parametrize("factor", [0.5, 1.0, 2.0])
def test_parts_fit_each_other(row: Articulation, factor: float) -> None:
    parent, child = (configured(name, factor) for name in sides(row))
    low = []
    for n in range(1, row.count + 1):
        assert mount_of(parent, row.parent_mount.format(n=n)) is not None
        assert mount_of(child, row.child_mount) is not None
        frame = child_frame(joint(row, n, row.start, factor), parent, child)
        there = posed(child, frame)
        shapes = footprints(there)
        low.append(min(p.z0 for p in shapes))
        deepest = max(
            prim_penetration(p, (0.0, 0.0, 0.0), 0.0, q, (0.0, 0.0, 0.0), 0.0)
            for p, q in itertools.product(shapes, footprints(parent))
        )
        assert deepest <= SLACK_CM * factor, f"{row.nouns[0]}: {deepest:.1f} cm deep"
    assert min(low) >= 0.0, "it hangs into the ground"
    if row.carries == "with":
        assert row.above_cm == pytest.approx(min(low) / factor, abs=1.0)


@pytest.mark.parametrize("name", sorted(parts()))
def test_mass_and_extents_are_those_of_the_drawing(name: str) -> None:
    entry = parts()[name]
    config = configured(name)
    sketch = build_sketch(entry, entry.dimensions_cm, entry.color_rgb)
    com, inertia = mass_properties(sketch.proxies, entry.mass_kg, sketch.densities)
    assert config.mass_kg == pytest.approx(entry.mass_kg)
    assert config.center_of_mass_cm == pytest.approx(com)
    assert config.inertia_kg_cm2 == pytest.approx(inertia)
    points = np.concatenate([part.mesh().vertices for part in sketch.parts])
    half = 0.5 * np.asarray(entry.dimensions_cm) + 1.0
    assert (np.abs(points[:, :2]) <= half[:2]).all()
    assert points[:, 2].min() >= -1.0 and points[:, 2].max() <= entry.dimensions_cm[2] + 1.0


def test_what_has_limits_starts_within_them() -> None:
    for row in ROWS:
        if row.kind in ("hinge", "slider"):
            low = -np.inf if row.lower is None else row.lower
            high = np.inf if row.upper is None else row.upper
            assert all(low <= p <= high for p in (row.start, row.opened or 0.0)), row.nouns


def test_cradle_balls_are_a_step_apart() -> None:
    """A gap of 4 mm between neighbours, which is more than they move in a step (3.6 mm): what touches
    shares a blow in every engine, and so does in Newton what is nearer (docs/engines/joints.md).
    """
    row = articulations()["newton's cradle"]
    parent, child = (configured(name) for name in sides(row))
    at = [child_frame(joint(row, n), parent, child).position for n in range(1, 6)]
    gaps = [float(np.linalg.norm(a - b)) - 5.0 for a, b in itertools.pairwise(at)]
    assert gaps == pytest.approx([0.4] * 4)


def test_nobody_finds_a_part_who_does_not_ask_for_it() -> None:
    assert not {e.name for e in catalogue()} & parts().keys()
