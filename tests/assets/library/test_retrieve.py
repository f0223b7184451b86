"""Embeddings, index and the confidence gate."""

from __future__ import annotations

import csv
from importlib.resources import files
from pathlib import Path

import numpy as np
import pytest

from esg.assets import search
from esg.assets.library.catalogue import catalogue, lexicon, singular
from esg.assets.library.embed import embed
from esg.assets.library.index import INDEX_FILE, texts_hash, unpack
from esg.assets.library.lookup import exact, head_match
from esg.assets.library.retrieve import GATE, confidence, is_foreign, rank

DATA = Path(__file__).parents[3] / "data"


def queries(name: str) -> list[tuple[str, set[str]]]:
    rows = csv.DictReader((DATA / name).read_text(encoding="utf-8").splitlines())
    return [(r["query"], set(filter(None, r["expected"].split(";")))) for r in rows]


def test_stored_index_is_in_sync_with_the_catalogue() -> None:
    data = files("esg.assets.data").joinpath(INDEX_FILE).read_bytes()
    assert unpack(data, catalogue()) is not None, "run python -m esg.assets.library.index"
    assert len(texts_hash(catalogue())) == 64


def test_stale_index_is_refused() -> None:
    data = files("esg.assets.data").joinpath(INDEX_FILE).read_bytes()
    assert unpack(data, catalogue()[1:]) is None


def test_embeddings_are_unit_repeatable_and_independent_of_their_batch() -> None:
    a = embed(["a wheelie bin", "car"])
    np.testing.assert_allclose(np.linalg.norm(a, axis=1), 1.0, rtol=1e-6)
    embed.__globals__["_embed_one"].cache_clear()
    assert (embed(["car"])[0] == a[1]).all()


def test_meaning_beats_spelling() -> None:
    assert search("settee")[0].asset_name == "sofa"
    assert search("notebook computer")[0].asset_name == "laptop"
    assert "bus" in {c.asset_name for c in search("public transport with many passenger seats", 3)}


@pytest.mark.parametrize(
    ("text", "expected"),
    [("rusty oil drum", "oil_drum"), ("bottle of red wine", "bottle"), ("voting machine", None)],
)
def test_head_noun_names_the_entry(text: str, expected: str | None) -> None:
    found = head_match(text)
    assert (found.name if found else None) == expected


def test_modifier_alone_does_not_open_the_gate() -> None:
    for text in ("bus ticket", "bowling score", "door handle", "voting machine", "umbrella stand"):
        assert confidence(text, rank(text)[0]) < GATE, text


def test_singular() -> None:
    pairs = {"boxes": "box", "buses": "bus", "glass": "glass", "cherries": "cherry", "cars": "car"}
    assert {k: singular(k) for k in pairs} == pairs


def test_lexicon_leads_to_known_entries() -> None:
    assert set(lexicon().values()) == {e.name for e in catalogue()}


@pytest.mark.slow
def test_retrieval_benchmark_holds() -> None:
    scores: dict[bool, list[float]] = {True: [], False: []}
    first = third = total = 0
    for text, expected in queries("retrieval_queries.csv"):
        candidates = rank(text)
        found = exact(text)
        names = [found.name] if found else []
        names += [c.asset_name for c in candidates if c.asset_name not in names]
        scores[bool(expected)].append(confidence(text, candidates[0]))
        if expected:
            total += 1
            first += names[0] in expected
            third += bool(set(names[:3]) & expected)
    inside, outside = np.array(scores[True]), np.array(scores[False])
    auc = (inside[:, None] > outside).mean() + 0.5 * (inside[:, None] == outside).mean()
    assert total + len(outside) >= 400
    assert first / total >= 0.85
    assert third / total >= 0.96
    assert auc >= 0.93


@pytest.mark.parametrize(
    ("text", "foreign"),
    [
        ("rote mülltonne", True),
        ("le petit chien", True),
        ("mesa de madera", True),
        ("schreibtischstuhl", True),
        ("красный мяч", True),
        ("a red wheelie bin", False),
        ("octopus", False),
        ("van", False),
        ("bottle of wine", False),
        ("x-ray machine", False),
    ],
)
def test_other_languages_are_told_apart(text: str, foreign: bool) -> None:
    assert is_foreign(text) is foreign


def test_other_languages_do_not_open_the_gate() -> None:
    for text in ("rote mülltonne", "mesa de madera", "le petit chien", "bottiglia di vino"):
        assert confidence(text, rank(text)[0]) < GATE, text
