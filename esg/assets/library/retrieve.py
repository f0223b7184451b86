"""Retrieval: which library entry a requirement means, how sure that is, and what came next.

An exact name or synonym decides at once. Otherwise candidates are ranked by

    score = 0.70 semantic + 0.18 category + 0.12 physical

with the best cosine of MiniLM embeddings over an entry's texts, the agreement of head nouns, and
the plausibility of size, mass, movability and shape. The confidence of the first candidate mixes
the cosine of the whole phrase with that of its head noun alone ("bowling shoes" are not bowling
pins), and the gate accepts it above a threshold; for everything else the nearest
kind stands in (esg/assets/library/nearest.py), or a plain body of the wanted size.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import lru_cache
import math
import re

import numpy as np

from esg.assets.imports.store import active_index
from esg.assets.library.catalogue import Entry, lexicon, normalize, parts
from esg.assets.library.index import Index, texts_of
from esg.assets.library.lookup import AMBIGUOUS_HEADS, exact, head_match, head_phrase
from esg.assets.library.proposal import is_own_name, misfit
from esg.graph.models import AssetRequirement, RetrievalCandidate

WEIGHTS = (0.70, 0.18, 0.12)
GATE = 0.65
"""Least confidence at which a candidate is used."""
_SIBLING_MARGIN = 0.15
_MODIFIER_PENALTY = 0.2
"""For a text that is only the first part of a compound ("cannon" of "cannon ball")."""
_FOREIGN_PENALTY = 0.3
"""For words that are not English: the embedding knows English, and finds some neighbour for all."""
_OTHER_KIND_PENALTY = 0.15
"""For a noun that WordNet puts under another kind; twice that for another class of things
("beehive" is near bees and no animal)."""
_CLASSES = ("animal", "person", "plant", "food")
_KEEP = 5


@dataclass(frozen=True)
class Decision:
    """What retrieval decided.

    Args:
        entry: The chosen entry; None if the gate closed.
        confidence: In [0, 1].
        runners_up: Best candidates, the chosen one first if there is one.
        shape: Plain shape to fall back to when there is no entry.
        reason: Why an entry stands in for a noun that is not its own; None where it does not.
    """

    entry: Entry | None
    confidence: float
    runners_up: tuple[RetrievalCandidate, ...]
    shape: str | None = None
    reason: str | None = None


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


def _category_score(entry: Entry, match: Entry | None) -> float:
    """1 for the entry that the head noun names, 0.8 for its kinds, 0.5 for its broader kinds."""
    if match is None:
        return 0.0
    if entry.name == match.name:
        return 1.0
    if match.name in entry.parents:
        return 0.8
    if entry.name in match.parents or set(entry.parents) & {match.parents[0]}:
        return 0.5
    return 0.0


def rank(
    text: str,
    requirement: AssetRequirement | None = None,
    k: int = _KEEP,
    index: Index | None = None,
) -> list[RetrievalCandidate]:
    """The k best entries for a text, best first."""
    index = index or active_index()
    query = index.vector(normalize(text) or text)
    semantic = index.scores(query)
    match = exact(text) or head_match(text)
    pool = list(np.argsort(-semantic, kind="stable")[: max(32, k)])
    if match is not None:
        pool += [i for i, e in enumerate(index.entries) if e.name == match.name and i not in pool]
    candidates: list[RetrievalCandidate] = []
    for i in pool:
        entry = index.entries[int(i)]
        category = _category_score(entry, match)
        physical = physical_score(entry, requirement) if requirement else 0.5
        score = float(np.dot(WEIGHTS, (float(semantic[i]), category, physical)))
        candidates.append(
            RetrievalCandidate(
                asset_name=qualified(entry),
                score=round(score, 6),
                semantic=round(float(semantic[i]), 6),
                category=category,
                physical=round(physical, 6),
            )
        )
    candidates.sort(key=lambda c: (-c.score, c.asset_name))
    return candidates[:k]


def confidence(text: str, best: RetrievalCandidate, index: Index | None = None) -> float:
    """How sure the first candidate is what the text means, in [0, 1].

    Tuned on `data/retrieval_tuning.csv`; measured on `data/retrieval_queries.csv`.
    """
    if exact(text) is not None:
        return 1.0
    index = index or active_index()
    i = next(k for k, e in enumerate(index.entries) if qualified(e) == best.asset_name)
    if any(normalize(name) == normalize(text) for name in texts_of(index.entries[i])):
        return 1.0
    if best.category >= 0.8 and not is_foreign(text):
        return round(0.6 + 0.4 * max(best.semantic, 0.0), 6)
    words = normalize(text)
    foreign = _FOREIGN_PENALTY if is_foreign(text) else 0.0
    head = head_phrase(text).split()[-1:] or [words]
    whole = index.vector(words)
    alone = index.vector(head[0])
    value = 0.5 * best.semantic + 0.5 * float(index.scores_of(i, alone).max())
    if head[0] in AMBIGUOUS_HEADS:
        value = 0.8 * best.semantic
    texts = texts_of(index.entries[i])
    nearest = normalize(texts[int(index.scores_of(i, whole).argmax())])
    if nearest.startswith(words) and nearest != words:
        value -= _MODIFIER_PENALTY
    value -= _OTHER_KIND_PENALTY * _strangeness(text, index.entries[i])
    return round(min(max(value - foreign, 0.0), 1.0), 6)


def _strangeness(text: str, entry: Entry) -> int:
    """0 where WordNet agrees with an entry or knows nothing, 1 for another kind, 2 for a class."""
    from esg.assets.library.hypernyms import kin

    relative = kin(text, whole=True)
    if relative is None:
        return 0
    kind = relative.entry
    lines = {kind.name, *kind.parents[:1]}, {entry.name, *entry.parents[:1]}
    if lines[0] & lines[1] or kind.name in entry.parents:
        return 0
    classes = [
        next((c for c in _CLASSES if c == e.name or c in e.parents), "") for e in (kind, entry)
    ]
    return 1 if classes[0] == classes[1] else 2


_FOREIGN_WORDS = frozenset(
    re.findall(
        r"\w+",
        "der die das ein eine einen und mit auf von aus dem den im le la les un une des du et avec "
        "sur sous pour de el los las una y con del para por il lo gli uno di da e su os um uma do "
        "het een van op",
    )
)
"""Articles and prepositions of neighbouring languages that are no English nouns."""


def is_foreign(text: str) -> bool:
    """Whether a phrase looks like another language than English.

    Letters outside the Latin alphabet or with diacritics; a foreign article or preposition; or
    words that the tokenizer cuts into three or more pieces on average (four for a word alone) and
    of which the library knows none.
    """
    if any(ch.isalpha() and not ch.isascii() for ch in text):
        return True
    words = re.findall(r"[a-z]+", text.lower())
    if not words:
        return bool(text.strip()) and not any(ch.isdigit() for ch in text)
    if len(words) > 1 and (words[0] in _FOREIGN_WORDS or set(words[1:-1]) & _FOREIGN_WORDS):
        return True
    if set(words) & _library_words():
        return False
    from esg.assets.library.embed import pieces

    return sum(pieces(w) for w in words) / len(words) >= (3.0 if len(words) > 1 else 4.0)


@lru_cache(maxsize=1)
def _library_words() -> frozenset[str]:
    return frozenset(w for phrase in lexicon() for w in phrase.split())


def qualified(entry: Entry) -> str:
    return entry.name if entry.library == "parametric" else f"{entry.library}/{entry.name}"


def decide(requirement: AssetRequirement) -> Decision:
    """Chooses the entry for a requirement, or closes the gate."""
    part = parts().get(requirement.asset_category)
    if part is not None:
        return Decision(part, 1.0, (_certain(part, requirement),))
    text = requirement.asset_category.replace("_", " ")
    found = exact(text)
    if found is not None and is_own_name(found, requirement):
        candidates = [_certain(found, requirement)]
        sure = 1.0
    else:
        candidates = rank(text, requirement)
        if found is not None:
            found = _better_sibling(found, candidates, requirement)
            candidates = [_certain(found, requirement), *candidates]
            candidates = [c for k, c in enumerate(candidates) if c.asset_name not in
                          {d.asset_name for d in candidates[:k]}][:_KEEP]  # fmt: skip
        sure = 1.0 if found is not None else confidence(text, candidates[0])
    if found is None and sure >= GATE:
        found = _entry(candidates[0])
    if found is not None and misfit(found, requirement, named=exact(text) is found):
        found, sure = None, min(sure, GATE)
    shape = None if found is not None else _plain(requirement)
    return Decision(found, sure, tuple(candidates), shape)


def closest(decision: Decision) -> Decision:
    """The decision of whoever has to take something of the library, whatever it is."""
    if decision.entry is not None:
        return decision
    best = decision.runners_up[0]
    reason = f"the library holds nothing closer than {best.asset_name}"
    return replace(decision, entry=_entry(best), shape=None, reason=reason)


def _entry(candidate: RetrievalCandidate) -> Entry:
    return next(e for e in active_index().entries if qualified(e) == candidate.asset_name)


def _certain(entry: Entry, requirement: AssetRequirement) -> RetrievalCandidate:
    physical = round(physical_score(entry, requirement), 6)
    return RetrievalCandidate(
        asset_name=qualified(entry), score=1.0, semantic=1.0, category=1.0, physical=physical
    )


def candidate_of(entry: Entry, requirement: AssetRequirement) -> RetrievalCandidate:
    """An entry as a candidate for a requirement, scored like the others."""
    text = requirement.asset_category.replace("_", " ")
    index = active_index()
    i = next(k for k, e in enumerate(index.entries) if qualified(e) == qualified(entry))
    semantic = float(index.scores_of(i, index.vector(normalize(text) or text)).max())
    category = _category_score(entry, exact(text) or head_match(text))
    physical = physical_score(entry, requirement)
    return RetrievalCandidate(
        asset_name=qualified(entry),
        score=round(float(np.dot(WEIGHTS, (semantic, category, physical))), 6),
        semantic=round(semantic, 6),
        category=category,
        physical=round(physical, 6),
    )


def _better_sibling(
    entry: Entry, candidates: list[RetrievalCandidate], requirement: AssetRequirement
) -> Entry:
    """Among entries of one kind that share a synonym ("lamp"), the one of the required size."""
    best, best_score = entry, physical_score(entry, requirement) + _SIBLING_MARGIN
    for candidate in candidates:
        if candidate.category < 0.5 or candidate.semantic < GATE:
            continue
        score = candidate.physical
        if score > best_score:
            best = next(e for e in active_index().entries if qualified(e) == candidate.asset_name)
            best_score = score
    return best


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
