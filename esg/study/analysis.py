"""What participants said: the paper's table with confidence intervals, and preferences in pairs.

A participant's mean over his ratings of a variant is one observation. Means and intervals are over
participants: Student's t at 95%. The spread beside a mean is the sample standard deviation over
participants. Preferences are Wilson intervals of the share among those who preferred one.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
import json
import math
from pathlib import Path
import statistics
from typing import Any

from esg.files import read_limited
from esg.outcomes import UserError
from esg.study.page import KEY_FORMAT, VERSION
from esg.untyped import is_list, is_object

ANSWERS_FORMAT = "esg-study-answers"
QUESTIONS = ("quality", "alignment")
CONFIDENCE = 0.95
MOST_BYTES = 4 * 2**20
_Z = 1.959963984540054
PAPER = {
    "full": ("4.4 ± 0.4", "4.5 ± 0.4"),
    "no_global": ("4.0 ± 0.5", "2.7 ± 0.6"),
    "no_initial": ("3.8 ± 0.5", "2.8 ± 0.9"),
    "no_dynamic": ("4.4 ± 0.4", "2.8 ± 0.8"),
    "no_generation": ("3.9 ± 0.5", "2.3 ± 0.6"),
}
"""Table tab:user_study: 20 scenes, 37 participants, scene quality and input alignment."""


@dataclass(frozen=True)
class Key:
    """What was shown.

    Args:
        study: Id of the study.
        variants: Names, in the order of the table.
        clips: Variant by clip.
        pairs: Ids of clips that were seen side by side.
    """

    study: str
    variants: tuple[str, ...]
    clips: dict[str, str]
    pairs: frozenset[frozenset[str]]


@dataclass(frozen=True)
class Estimate:
    """A mean over participants.

    Args:
        mean: Of their means.
        std: Sample standard deviation over participants; 0 of one.
        low, high: Ends of the interval; NaN of one participant.
        participants: How many.
    """

    mean: float
    std: float
    low: float
    high: float
    participants: int

    def to_json(self) -> dict[str, Any]:
        """Plain values; no interval of one participant."""
        known = math.isfinite(self.low)
        return {
            "mean": self.mean,
            "std": self.std,
            "interval": [self.low, self.high] if known else None,
            "participants": self.participants,
        }


def read_key(path: Path) -> Key:
    """The key of a study.

    Raises:
        UserError: If it is none.
    """
    data = _object(path)
    if data.get("format") != KEY_FORMAT or data.get("version") != VERSION:
        raise UserError(f"{path} is no key of a study; `esg study RUN` writes one beside its page")
    try:
        clips = {str(k): str(v["variant"]) for k, v in data["clips"].items()}
        pairs = frozenset(frozenset(map(str, pair)) for pair in data["pairs"])
        return Key(str(data["study"]), tuple(map(str, data["variants"])), clips, pairs)
    except (KeyError, TypeError, AttributeError) as error:
        raise UserError(f"{path} is a damaged key of a study: {error}") from None


def read_answers(paths: Sequence[Path], key: Key) -> list[dict[str, Any]]:
    """The answers of participants, one file each.

    Raises:
        UserError: With everything that is wrong with any of them.
    """
    problems: list[str] = []
    found: list[dict[str, Any]] = []
    seen: dict[Any, Path] = {}
    for path in paths:
        try:
            data = _object(path)
        except UserError as error:
            problems.append(str(error))
            continue
        wrong = _faults(data, key)
        participant = data.get("participant")
        if not wrong and participant in seen:
            wrong = [f"participant {participant} has answered in {seen[participant]} already"]
        problems += [f"{path}: {what}" for what in wrong]
        seen.setdefault(participant, path)
        found.append(data)
    if problems:
        raise UserError("\n".join(problems))
    if not found:
        raise UserError("--analyse: name one file of answers or more")
    return found


def _object(path: Path) -> dict[str, Any]:
    try:
        data = json.loads(read_limited(path, MOST_BYTES))
    except OSError as error:
        raise UserError(f"{path} cannot be read: {error.strerror or error}") from None
    except (ValueError, RecursionError) as error:
        raise UserError(f"{path} is no JSON: {error}") from None
    if not is_object(data):
        raise UserError(f"{path} is no JSON object")
    return data


def _faults(data: dict[str, Any], key: Key) -> list[str]:
    """What is wrong with one participant's answers."""
    if data.get("format") != ANSWERS_FORMAT or data.get("version") != VERSION:
        return ["it is no file of answers"]
    if data.get("study") != key.study:
        return [f"it answers study {data.get('study')!r}, the key is of {key.study!r}"]
    wrong: list[str] = []
    if data.get("consent") is not True:
        wrong.append("it holds no consent")
    if not isinstance(data.get("participant"), int):
        wrong.append("it has no participant")
    ratings, pairs = data.get("ratings"), data.get("pairs")
    if not is_list(ratings) or not is_list(pairs) or not all(map(is_object, [*ratings, *pairs])):
        return [*wrong, "its ratings and pairs are no lists of objects"]
    return [*wrong, *_rating_faults(ratings, key), *_pair_faults(pairs, key)]


def _rating_faults(ratings: Sequence[Any], key: Key) -> list[str]:
    wrong: list[str] = []
    for k, row in enumerate(ratings):
        if row.get("clip") not in key.clips:
            wrong.append(f"ratings/{k} is of {row.get('clip')!r}, which was not shown")
        for question in QUESTIONS:
            if row.get(question) not in (1, 2, 3, 4, 5) or isinstance(row.get(question), bool):
                wrong.append(f"ratings/{k}/{question} is {row.get(question)!r}, not 1 to 5")
    rated = [str(row.get("clip")) for row in ratings]
    if missing := sorted(set(key.clips) - set(rated)):
        wrong.append(f"{len(missing)} of {len(key.clips)} clips are not rated")
    if len(set(rated)) != len(rated):
        wrong.append("a clip is rated twice")
    return wrong


def _pair_faults(pairs: Sequence[Any], key: Key) -> list[str]:
    wrong: list[str] = []
    for k, row in enumerate(pairs):
        both = frozenset((str(row.get("first")), str(row.get("second"))))
        if both not in key.pairs:
            wrong.append(f"pairs/{k} was not shown")
        for question in QUESTIONS:
            if row.get(question) is not None and row.get(question) not in both:
                wrong.append(f"pairs/{k}/{question} prefers neither of the two")
    return wrong


def estimate(values: Sequence[float]) -> Estimate:
    """Mean, spread and interval (Student's t) over participants."""
    from scipy.stats import t

    mean, count = statistics.fmean(values), len(values)
    if count < 2:
        return Estimate(mean, 0.0, math.nan, math.nan, count)
    std = statistics.stdev(values)
    half = float(t.ppf(0.5 + CONFIDENCE / 2, count - 1)) * std / math.sqrt(count)
    return Estimate(mean, std, mean - half, mean + half, count)


def ratings_of(answers: Sequence[Mapping[str, Any]], key: Key) -> dict[str, dict[str, Estimate]]:
    """Estimates by variant and question."""
    out: dict[str, dict[str, Estimate]] = {}
    for variant in key.variants:
        out[variant] = {
            question: estimate(
                [
                    statistics.fmean(
                        row[question] for row in one["ratings"] if key.clips[row["clip"]] == variant
                    )
                    for one in answers
                ]
            )
            for question in QUESTIONS
        }
    return out


@dataclass(frozen=True)
class Preference:
    """How two variants did side by side in one question.

    Args:
        one, other: The variants.
        question: quality or alignment.
        wins, losses, same: Times that `one` was preferred, that `other` was, that neither was.
        low, high: Interval of the share of `one` among the preferences; NaN without any.
    """

    one: str
    other: str
    question: str
    wins: int
    losses: int
    same: int
    low: float
    high: float


def preferences_of(answers: Sequence[Mapping[str, Any]], key: Key) -> list[Preference]:
    """Preferences by pair of variants and question."""
    counts: dict[tuple[str, str, str], list[int]] = {}
    rank = {variant: k for k, variant in enumerate(key.variants)}
    for row in (row for one in answers for row in one["pairs"]):
        shown = sorted((key.clips[row["first"]], key.clips[row["second"]]), key=rank.__getitem__)
        for question in QUESTIONS:
            count = counts.setdefault((shown[0], shown[1], question), [0, 0, 0])
            chosen = None if row[question] is None else key.clips[row[question]]
            count[2 if chosen is None else shown.index(chosen)] += 1
    return [
        _preference(one, other, question, count) for (one, other, question), count in counts.items()
    ]


def _preference(one: str, other: str, question: str, count: Sequence[int]) -> Preference:
    wins, losses, same = count
    low, high = wilson(wins, wins + losses)
    return Preference(one, other, question, wins, losses, same, low, high)


def wilson(wins: int, count: int) -> tuple[float, float]:
    """Wilson's interval of a share at 95%; NaN of nothing."""
    if not count:
        return math.nan, math.nan
    share, square = wins / count, _Z * _Z
    middle = (share + square / (2 * count)) / (1 + square / count)
    half = _Z / (1 + square / count)
    half *= math.sqrt(share * (1 - share) / count + square / (4 * count * count))
    return middle - half, middle + half
