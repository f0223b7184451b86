"""What a batch leaves: rows of the tables, recordings, and why scenes failed."""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping, Sequence
import json
from pathlib import Path
import shutil
from typing import TYPE_CHECKING, Any

from esg.dataset.job import BatchJob, BatchResult
from esg.dataset.plan import SAMPLE_EVERY, PlannedScene
from esg.outcomes import Outcome
from esg.pipeline import SceneState, failures, implausible

if TYPE_CHECKING:
    from esg.costs.spent import Meter
    from esg.dataset.clips.batch import Rendered
    from esg.dataset.running import Made


def write_batch(job: BatchJob, made: Made, rendered: Rendered, spent: Meter) -> BatchResult:
    """Writes all files of a batch but its clips, which are there.

    Args:
        job: The batch.
        made: Its scenes.
        rendered: Their clips.
        spent: What annotations, meshes and recordings take is added.
    """
    from esg.dataset.annotations.rows import annotated
    from esg.store.records import SceneRecord, record_of
    from esg.store.tables import write_tables

    records: list[SceneRecord] = []
    met: list[bool] = []
    verified: list[bool] = []
    packed: dict[Path, None] = {}
    states = made.states
    for scene, state, other in zip(job.scenes, states, made.others, strict=True):
        record = record_of(
            state,
            job.run,
            scene_id=scene.scene_id,
            level=scene.level,
            fps=job.spec.fps,
            split=scene.split,
            family=scene.family,
            extra=_columns(scene, state),
        )
        with spent.on("annotations"):
            rows = annotated(job, state, other, dict(record.rows))
        # Everything but `timings` is the same whenever and however often a scene is made.
        row = {**rows["scenes"][0], "seconds": None, "cached_stages": None, "artifacts": None}
        if job.spec.meshes and row["manifest"]:
            with spent.on("meshes"):
                rows["meshes"], buffers = _meshes(job, state, row)
            packed |= dict.fromkeys(buffers)
        met.append(bool(row["verified"]))
        row["verified"] = met[-1] and _as_said(state, rows["statements"])
        verified.append(row["verified"])
        clips = rendered.rows.get(scene.scene_id, [])
        records.append(SceneRecord({**rows, "scenes": [row], "clips": clips}))
    written = list(packed)
    with spent.on("recordings"):
        for scene, state, record, good in zip(job.scenes, states, records, met, strict=True):
            recorded = _recordings(job, scene, state, good)
            record.rows["scenes"][0]["preview"] = _picture(job, recorded)
            written += recorded
    written += write_tables(job.out / "parts", records, name=job.name).values()
    return BatchResult(
        number=job.number,
        scenes=len(states),
        verified=sum(verified),
        outcomes=dict(Counter(s.outcome.value if s.outcome else "unfinished" for s in states)),
        failures=[*_failures(job, states, met), *_unseen(job, rendered)],
        crashes={
            scene.scene_id: entry["traceback"]
            for scene, state in zip(job.scenes, states, strict=True)
            for entry in state.log
            if "traceback" in entry
        }
        | rendered.crashes,
        files={
            p.relative_to(job.out).as_posix(): p.stat().st_size for p in (*written, *rendered.files)
        },
    )


def _meshes(
    job: BatchJob, state: SceneState, row: Mapping[str, Any]
) -> tuple[list[dict[str, Any]], list[Path]]:
    """Rows of table `meshes` of a scene, and the buffers they need."""
    from esg.dataset.meshes import pack_meshes
    from esg.stages import load_doc

    rows, buffers = pack_meshes(load_doc(state), job.out)
    common = {k: row[k] for k in ("run_id", "scene_key", "suite", "scene_id", "seed", "prompt")}
    return [{**common, **mesh} for mesh in rows], buffers


def _picture(job: BatchJob, made: Sequence[Path]) -> dict[str, Any] | None:
    """The contact sheet among a scene's recordings, as a value of type `image`."""
    for path in made:
        if path.suffix == ".png":
            return {"bytes": path.read_bytes(), "path": path.relative_to(job.out).as_posix()}
    return None


def _as_said(state: SceneState, statements: Sequence[Mapping[str, Any]]) -> bool:
    """Whether a stranger who reads the sentence sees it all: nothing was given up or left out."""
    asked = [row for row in statements if row["source"] == "suite"]
    return state.outcome is Outcome.SOLVED and all(row["kept"] for row in asked)


def _columns(scene: PlannedScene, state: SceneState) -> dict[str, Any]:
    from esg.store import shapes

    manifest, expected = None, scene.request.suite_scene
    if "compile" in state.artifacts:
        manifest = (state.artifact("compile") / "manifest.json").read_text("utf-8")
    return {
        "rule": scene.rule or None,
        "pair": scene.pair or None,
        "changed": scene.changed or None,
        "parameters": shapes.parameters(json.loads(scene.parameters)) if scene.parameters else None,
        "expectation": shapes.expectation(json.loads(expected)) if expected else None,
        "manifest": manifest,
    }


def _failures(
    job: BatchJob, states: Sequence[SceneState], met: Sequence[bool]
) -> list[dict[str, Any]]:
    """Scenes that failed, and why.

    The expectation decides: a scene whose layout and events are what its sentence says is no
    failure, whatever the optimizer thought of it; one that ended well but not as its sentence says
    is. A `partial` or implausible scene is one only if the dataset is strict.
    """
    told = {row["scene"]: row for row in failures(states, strict=job.spec.strict)}
    out: list[dict[str, Any]] = []
    for scene, state, good in zip(job.scenes, states, met, strict=True):
        row = told.get(scene.scene_id)
        lacking = job.spec.strict and (state.outcome is Outcome.PARTIAL or implausible(state))
        if good and (row is None or not lacking):
            continue
        if row is None:
            row = {
                "scene": scene.scene_id,
                "prompt": state.request.prompt,
                "seed": state.request.seed,
                "outcome": "not_as_stated",
                "reason": unmet(state),
                "stage": "judge",
            }
        out.append({**row, "index": scene.index, "rule": scene.rule, "level": scene.level})
    return out


def _unseen(job: BatchJob, rendered: Rendered) -> list[dict[str, Any]]:
    """Scenes that could not be rendered."""
    facts = {s.scene_id: {"rule": s.rule, "level": s.level} for s in job.scenes}
    return [{**row, **facts[row["scene"]]} for row in rendered.failures]


def unmet(state: SceneState) -> str:
    """Which expectations a judged scene does not meet."""
    from esg.stages import load_verdict

    verdict = load_verdict(state)
    parts = [f"{e.id} ({e.type}): {e.reason}" for e in verdict.events if not e.completed]
    parts += verdict.layout.faults
    return "; ".join(parts) or "the layout is invalid"


def _recordings(job: BatchJob, scene: PlannedScene, state: SceneState, met: bool) -> list[Path]:
    """MCAP and picture of a scene, if it is one of those that get them."""
    if "judge" not in state.artifacts:
        return []
    sampled = scene.index % SAMPLE_EVERY == 0
    mcap = {"all": True, "failed": not met, "sample": sampled, "none": False}
    picture = {"all": True, "sample": sampled, "none": False}
    out: list[Path] = []
    if not (mcap[job.spec.mcap] or picture[job.spec.previews]):
        return out
    from esg.engines.rollout_file import load_rollout
    from esg.stages import ROLLOUT, load_doc, load_scene, load_verdict

    doc, verdict = load_doc(state), load_verdict(state)
    physical, program = load_scene(state)
    rollout = load_rollout(state.artifact("replay") / ROLLOUT)
    if mcap[job.spec.mcap]:
        from esg.store.mcap_log import write_mcap

        path = job.out / "mcap" / f"{scene.scene_id}.mcap"
        path.parent.mkdir(parents=True, exist_ok=True)
        write_mcap(path, physical, program, rollout, verdict, doc)
        out.append(path)
    if picture[job.spec.previews]:
        out += _preview(job, scene, state, (physical, rollout, verdict, doc))
    return out


def _preview(
    job: BatchJob, scene: PlannedScene, state: SceneState, parts: tuple[Any, Any, Any, Any]
) -> list[Path]:
    from esg.dressing import dress
    from esg.files import atomic_write
    from esg.view.preview import preview

    physical, rollout, verdict, doc = parts
    folder = job.work / "preview"
    folder.mkdir(parents=True, exist_ok=True)
    rate = f"{1 / rollout.dt:.0f} Hz"
    outcome = state.outcome.value if state.outcome else ""
    note = f"{outcome}  |  replayed in {rollout.engine} at {rate}"
    try:
        doc = dress(doc, physical, rollout, seed=state.request.seed)
        preview(physical, rollout, verdict, doc, folder, note=note)
        path = job.out / "previews" / f"{scene.scene_id}.png"
        atomic_write(path, lambda target: _copy(folder / "preview.png", target))
        return [path]
    except OSError:
        raise
    except Exception:  # a picture is no reason to fail a scene
        return []


def _copy(source: Path, target: Path) -> None:
    shutil.copyfile(source, target)
