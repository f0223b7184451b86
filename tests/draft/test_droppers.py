"""Who drops a thing stands by it; people and animals look at it, machines need not."""

from __future__ import annotations

import pytest

from esg.draft import draft


@pytest.mark.parametrize(
    ("prompt", "looks"),
    [
        ("A boy drops a ball into a bucket.", True),
        ("A crow drops a nut onto a roof.", True),
        ("A robot arm drops a ball into a box.", False),
        ("A crane drops a crate onto a truck.", False),
    ],
)
def test_who_drops_a_thing_looks_at_it_if_it_can(prompt: str, looks: bool) -> None:
    doc = draft(prompt, seed=0, drafter="rules")
    words = prompt.lower().split()
    who = "_".join(words[1 : words.index("drops")]) + "_1"
    edges = doc.spatial_relation_graph.edges.binary_relations
    assert any(e.from_ == who for e in edges)
    what = words[words.index("drops") + 2] + "_1"
    faced = [e.to for e in edges if e.from_ == who and e.relation_type.value == "face"]
    assert (what in faced) is looks
