"""The sweeps of the scaling benchmark grow what they say, and its picture shows all of it."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from benchmarks import scaling
from esg.assets import resolve
from esg.draft import draft


@pytest.mark.parametrize("sweep", ["bystanders", "pairs", "chain"])
def test_sweeps_have_as_many_bodies_and_events_as_they_say(sweep: str) -> None:
    """Every body is an object of its own and every hit an event, up to 30 bodies and 15 events."""
    expected = {
        "bystanders": [(n, 1) for n in scaling.BODIES],
        "pairs": [(2 * n, n) for n in scaling.PAIRS],
        "chain": [(n + 1, n) for n in scaling.HITS],
    }[sweep]
    found = []
    for name, _, prompt in scaling.prompts():
        if name != sweep:
            continue
        doc = resolve(draft(prompt, seed=0), seed=0)
        assert doc.timeline_system is not None
        nodes = doc.timeline_system.sequence_graph.nodes
        # What rolls into a cup or a hole enters it.
        hits = [n for n in nodes if n.event.value in ("Collision", "EnterRegion")]
        # The ground is a node of the spatial graph, too.
        found.append((len(doc.spatial_relation_graph.nodes) - 1, len(hits)))
    assert found == expected


def test_plot_draws_every_sweep(tmp_path: Path) -> None:
    """All four colours are in the picture, in both rows."""
    from PIL import Image

    rows = [
        {"sweep": sweep, "bodies": 2 * k, "events": k, "candidates": 64 * k if sweep == "candidates"
         else None, "cpu_s": 0.3 * k, "peak_rss_mib": 400.0 + k}
        for sweep in scaling.COLOURS
        for k in (1, 2, 4)
    ]  # fmt: skip
    scaling.plot(json.loads(json.dumps(rows)), tmp_path / "scaling.png")
    image = Image.open(tmp_path / "scaling.png").convert("RGB")
    for half in (0, 1):
        part = image.crop((0, half * scaling.HEIGHT, image.width, (half + 1) * scaling.HEIGHT))
        colours = {c for _, c in part.getcolors(1 << 20) or []}
        assert set(scaling.COLOURS.values()) <= colours
