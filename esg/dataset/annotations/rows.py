"""Rows of a scene beside those of its record: texts, other engines, what-ifs."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
import logging
from typing import TYPE_CHECKING, Any

from esg.dataset.annotations.captions import captions
from esg.dataset.annotations.clauses import Story
from esg.dataset.annotations.motion import Motion
from esg.dataset.annotations.nouns import Nouns
from esg.dataset.annotations.questions import questions

if TYPE_CHECKING:
    from esg.dataset.job import BatchJob
    from esg.dataset.whatifs.outcomes import Alternatives
    from esg.pipeline import SceneState

Rows = dict[str, list[dict[str, Any]]]

_log = logging.getLogger(__name__)
_COMMON = ("run_id", "scene_key", "suite", "scene_id", "seed", "prompt")


def annotated(job: BatchJob, state: SceneState, other: Alternatives, rows: Rows) -> Rows:
    """A record's rows with those of its texts and its other replays, without its run.

    Args:
        job: The batch.
        state: The scene.
        other: What its other replays came to.
        rows: Of its record, by table.
    """
    scene = rows["scenes"][0]
    common = {name: scene[name] for name in _COMMON}
    out = {table: found for table, found in rows.items() if table != "runs"}
    pair = scene["scene_id"]
    what_ifs = [{**common, "pair": f"{pair}/{r['variable']}", **r} for r in other.what_ifs]
    out["engine_events"] = [{**common, **r} for r in other.engine_events]
    out["what_ifs"] = what_ifs
    out["scenes"] = [{**scene, "engines_agree": _agree(other.engine_events)}]
    if job.spec.annotations == "all" and rows["trajectories"] and "judge" in state.artifacts:
        try:
            told = story(state, rows["trajectories"][0])
            out |= text_rows(told, common, rows["statements"], what_ifs)
        except Exception as error:  # a text is no reason to fail a scene
            _log.warning("%s has no captions: %s", scene["scene_id"], error)
    return out


def _agree(events: Sequence[Mapping[str, Any]]) -> bool | None:
    """Whether all engines see every event alike; None if nobody asked them, or one failed."""
    answers = {r.get("agrees") for r in events}
    return None if not answers or None in answers else answers == {True}


def story(state: SceneState, row: Mapping[str, Any]) -> Story:
    """A judged scene with its recorded trajectory."""
    from esg.dataset.whatifs.stage import expectation
    from esg.stages import load_scene, load_verdict

    expected = expectation(state)
    scene, program = load_scene(state)
    return Story(scene, program, Motion(row, scene), Nouns(scene), load_verdict(state), expected)


def text_rows(
    told: Story,
    common: Mapping[str, Any],
    statements: Sequence[Mapping[str, Any]],
    what_ifs: Sequence[Mapping[str, Any]],
) -> Rows:
    """Rows of tables `captions` and `questions`.

    Args:
        told: The scene with what its replay shows.
        common: Columns that all tables share.
        statements: Rows of table `statements` of the scene.
        what_ifs: Rows of table `what_ifs` of the scene.
    """
    seed = f"{common['scene_id']}/{common['seed']}"
    texts = captions(told, seed)
    names = told.motion.names
    kept = [r["words"] for r in statements if r["source"] == "prompt" and r["kept"] and r["words"]]
    caption = {
        **common,
        "short": texts.short,
        "medium": texts.medium,
        "long": texts.long,
        "event_ids": [c.event for c, _ in texts.events],
        "event_texts": [text for _, text in texts.events],
        "event_times_s": [c.time for c, _ in texts.events],
        "hit_a": [names[h.a] for h in told.motion.hits],
        "hit_b": [names[h.b] for h in told.motion.hits],
        "hit_times_s": [h.time for h in told.motion.hits],
        "hit_impulses_ns": [h.impulse for h in told.motion.hits],
        "statements": list(dict.fromkeys(kept)),
    }
    asked = [
        {
            **common,
            "question_index": k,
            **{name: getattr(q, name) for name in _QUESTION},
            "choices": list(q.choices),
            "arguments": list(q.arguments),
        }
        for k, q in enumerate(questions(told, seed, what_ifs))
    ]
    return {"captions": [caption], "questions": asked}


_QUESTION = ("kind", "question", "answer", "value", "unit", "measure", "measured_by")
