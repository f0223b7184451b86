"""Retrieval: which library entry a requirement means, how sure that is, and what came next.

An exact name or synonym decides at once. Otherwise candidates are ranked by

    score = 0.70 semantic + 0.18 category + 0.12 physical

with the cosine of MiniLM embeddings, the agreement of head nouns and hypernyms, and the plausibility
of size, mass, movability and shape. The gate accepts the first candidate if its cosine is high
enough for how well its category agrees; everything else becomes a plain body of the wanted size.
"""

from __future__ import annotations

from dataclasses import dataclass
import math

import numpy as np

from esg.assets.index import Index, active_index
from esg.assets.library import Entry, entries_by_name, lexicon, normalize
from esg.graph.models import AssetRequirement, RetrievalCandidate

WEIGHTS = (0.70, 0.18, 0.12)
GATE_SAME_CATEGORY, GATE_OTHER = 0.50, 0.66
_KEEP = 5


@dataclass(frozen=True)
class Decision:
    """What retrieval decided.

    Args:
        entry: The chosen entry; None if the gate closed.
        confidence: In [0, 1].
        runners_up: Best candidates, the chosen one first if there is one.
        shape: Plain shape to fall back to when there is no entry.
    """

    entry: Entry | None
    confidence: float
    runners_up: tuple[RetrievalCandidate, ...]
    shape: str | None = None


def exact(text: str) -> Entry | None:
    """The entry whose name or synonym is `text`, else the one named by its last words."""
    words = normalize(text).split()
    name = lexicon().get(" ".join(words))
    return entries_by_name()[name] if name else None


def head_match(text: str) -> Entry | None:
    """The entry named by the longest proper suffix of `text` ("rusty oil drum" -> oil drum)."""
    words = normalize(text).split()
    for start in range(1, len(words)):
        name = lexicon().get(" ".join(words[start:]))
        if name:
            return entries_by_name()[name]
    return None


def physical_score(entry: Entry, requirement: AssetRequirement) -> float:
    """Agreement of size, mass, movability and shape, in [0, 1]."""
    size = sorted(requirement.expected_dimensions_cm)
    own = sorted(entry.dimensions_cm)
    spread = sum(abs(math.log(a / b)) for a, b in zip(size, own, strict=True)) / 3
    mass = abs(math.log(requirement.expected_mass_kg / entry.mass_kg))
    score = 0.5 * math.exp(-spread) + 0.3 * math.exp(-mass / 2)
    score += 0.1 * (entry.movable == requirement.is_movable)
    ball = "rolls" in entry.flags
    score += 0.1 * (requirement.shape is None or (requirement.shape == "sphere") == ball)
    return score


def _category_score(entry: Entry, text: str, match: Entry | None) -> float:
    words = set(normalize(text).split())
    names = {normalize(entry.name), *(normalize(s) for s in entry.synonyms)}
    heads = {n.split()[-1] for n in names}
    tail = normalize(text).split()[-1:] or [""]
    if match is not None and (entry.name == match.name or match.name in entry.parents):
        return 1.0
    if tail[0] in heads:
        return 1.0
    if words & (set(entry.parents) | heads):
        return 0.6
    return 0.0


def rank(
    text: str,
    requirement: AssetRequirement | None = None,
    k: int = _KEEP,
    index: Index | None = None,
) -> list[RetrievalCandidate]:
    """The k best entries for a text, best first."""
    from esg.assets.embed import embed

    index = index or active_index()
    query = embed([normalize(text) or text])[0]
    semantic = index.scores(query)
    match = exact(text) or head_match(text)
    pool = np.argsort(-semantic, kind="stable")[: max(24, k)]
    candidates = []
    for i in pool:
        entry = index.entries[int(i)]
        category = _category_score(entry, text, match)
        physical = physical_score(entry, requirement) if requirement else 0.5
        score = float(np.dot(WEIGHTS, (float(semantic[i]), category, physical)))
        candidates.append(
            RetrievalCandidate(
                asset_name=_qualified(entry),
                score=round(score, 6),
                semantic=round(float(semantic[i]), 6),
                category=category,
                physical=round(physical, 6),
            )
        )
    candidates.sort(key=lambda c: (-c.score, c.asset_name))
    return candidates[:k]


def _qualified(entry: Entry) -> str:
    return entry.name if entry.library == "parametric" else f"{entry.library}/{entry.name}"


def decide(requirement: AssetRequirement, label: str = "") -> Decision:
    """Chooses the entry for a requirement, or closes the gate."""
    category = requirement.asset_category
    found = exact(category)
    if found is not None:
        chosen = RetrievalCandidate(
            asset_name=found.name,
            score=1.0,
            semantic=1.0,
            category=1.0,
            physical=round(physical_score(found, requirement), 6),
        )
        return Decision(found, 1.0, (chosen,))
    text = category.replace("_", " ")
    candidates = rank(text, requirement)
    best = candidates[0]
    gate = GATE_SAME_CATEGORY if best.category >= 1.0 else GATE_OTHER
    if best.semantic >= gate:
        entry = next(e for e in active_index().entries if _qualified(e) == best.asset_name)
        return Decision(entry, round(min(best.semantic, 1.0), 6), tuple(candidates))
    return Decision(None, round(max(best.semantic, 0.0), 6), tuple(candidates), _plain(requirement))


_ROUND = ("ball", "sphere", "globe", "orb", "bead", "marble", "melon", "berry", "fruit", "nut")
_TALL = (
    "can",
    "pipe",
    "tube",
    "candle",
    "jar",
    "tower",
    "silo",
    "pole",
    "roll",
    "battery",
    "bin",
    "barrel",
    "drum",
    "tank",
    "keg",
    "vial",
    "cup",
    "pot",
    "bucket",
    "log",
    "coin",
    "wheel",
)


def _plain(requirement: AssetRequirement) -> str:
    """Plain shape of a fallback: as required, else by the noun, else a box."""
    if requirement.shape in ("sphere", "box", "cylinder", "capsule"):
        return requirement.shape
    words = normalize(requirement.asset_category).split()
    head = words[-1] if words else ""
    if head.endswith(_ROUND):
        return "sphere"
    return "cylinder" if head.endswith(_TALL) else "box"
