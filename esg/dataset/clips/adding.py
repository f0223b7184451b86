"""Clips for a dataset that is finished: which scenes lack them, and putting them in.

rendering/           below the dataset, while it lasts: what a dataset's folder has while it is made
  meta/plan.json     what is rendered: a resumed run must agree with it
  marks/, parts/     of batches of scenes
  clips/             scenes that are rendered
  moving             all batches are done; their scenes are being moved into the dataset

The dataset is whole and says the same all the while; it changes when everything is rendered.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
import json
import os
from pathlib import Path
import shutil

from esg.dataset.clips.batch import NOT_RENDERED
from esg.dataset.clips.subjects import told_scenes
from esg.dataset.clips.writing import sweep_clips
from esg.dataset.finish import describe_again, failures_of, write_json
from esg.dataset.folder import PLAN, DatasetFolder
from esg.dataset.job import CROSSCHECK, RENDER, BatchJob, BatchResult, batch_name
from esg.dataset.plan import DatasetSpec, PlannedScene, RenderSpec
from esg.outcomes import UserError
from esg.pipeline import SceneRequest
from esg.store.assembling import assemble_tables
from esg.store.tables import part_files, read_table, write_part

TABLES = ("clips", "truth_checks")
"""What clips leave."""
SCAFFOLD = "rendering"
_MOVING = "moving"


@dataclass(frozen=True)
class Adding:
    """Clips that a finished dataset is to get.

    Args:
        folder: Of the dataset.
        spec: Of the dataset, with what is rendered now.
        scenes: Those that lack these clips, in the order of their keys.
        batch: Scenes a batch.
    """

    folder: DatasetFolder
    spec: DatasetSpec
    scenes: tuple[PlannedScene, ...]
    batch: int

    @property
    def scaffold(self) -> DatasetFolder:
        """Where it is worked."""
        return DatasetFolder(self.folder.path / SCAFFOLD, self.folder.label)

    @property
    def numbers(self) -> range:
        """Of its batches."""
        return range(-(-len(self.scenes) // self.batch))

    def jobs(self, numbers: Sequence[int], stage_limit_s: float, url: str = "") -> list[BatchJob]:
        """Batches to render.

        Args:
            numbers: Which.
            stage_limit_s: As of `BatchJob`.
            url: Where the dataset is; empty: on this machine.
        """
        out = self.scaffold.path.resolve()
        run = self.folder.run()
        return [
            BatchJob(
                number=n,
                spec=self.spec,
                run=run,
                scenes=self.scenes[n * self.batch : (n + 1) * self.batch],
                out=out,
                work=out / "work" / batch_name(n),
                stage_limit_s=stage_limit_s,
                url=url,
                source=self.folder.path.resolve(),
            )
            for n in numbers
        ]


def begin_adding(
    folder: DatasetFolder, render: RenderSpec, *, batch: int | None, resume: bool
) -> Adding:
    """Finds out what is to be rendered.

    Args:
        folder: Of a finished dataset.
        render: What to render.
        batch: Scenes a batch; default as of the dataset.
        resume: Whether a rendering that was begun may be continued.

    Raises:
        UserError: If the dataset is not finished, or another rendering of it was begun.
    """
    spec = folder.spec()
    if spec is None:
        raise UserError(f"{folder.label} is no dataset (it lacks {PLAN})")
    if not folder.finished():
        raise UserError(
            f"{folder.label} is not finished: go on with it first, esg dataset --out "
            f"{folder.label} --resume"
        )
    plan = folder.path / SCAFFOLD / PLAN
    size = batch or spec.batch_size
    asked = {"render": render.model_dump(mode="json"), "batch": size}
    if plan.is_file():
        begun = json.loads(plan.read_bytes())
        if not resume:
            raise UserError(
                f"a rendering of {folder.label} was begun; add --resume to go on with it, or "
                f"delete {plan.parent.parent}"
            )
        if begun != asked:
            raise UserError(
                f"a rendering of {folder.label} was begun with other settings: repeat "
                f"{json.dumps(begun)}, or delete {plan.parent.parent}"
            )
    else:
        write_json(plan, asked)
    scenes = tuple(_lacking(folder.path, spec.render, render))
    return Adding(folder, spec.model_copy(update={"render": render}), scenes, size)


def _lacking(folder: Path, had: RenderSpec | None, render: RenderSpec) -> Iterator[PlannedScene]:
    """Replayed scenes without the clips that are asked for, or with others."""
    there = _there(folder, render) if had is not None and _alike(had, render) else {}
    for index, row in enumerate(told_scenes(folder)):
        if there.get(row["scene_key"], 0) < render.cameras:
            request = SceneRequest(row["prompt"], seed=row["seed"], name=row["scene_id"])
            yield PlannedScene(index, row["scene_id"], request, "", row["split"])


def _alike(had: RenderSpec, render: RenderSpec) -> bool:
    """Whether clips differ in nothing but how many there are and of what."""
    own = {"channels": render.channels, "cameras": render.cameras, "device": render.device}
    return had.model_copy(update=own) == render


def _there(folder: Path, render: RenderSpec) -> dict[str, int]:
    """Number of clips by scene that have all channels."""
    out: dict[str, int] = {}
    for path in part_files(folder, "clips"):
        for row in read_table(path, ["scene_key", "channels"]).to_pylist():
            if set(render.channels) <= set(row["channels"]):
                out[row["scene_key"]] = out.get(row["scene_key"], 0) + 1
    return out


def moving(adding: Adding) -> bool:
    """Whether all is rendered, and a process was killed while it put the clips in."""
    return (adding.scaffold.path / _MOVING).exists()


def add_clips(adding: Adding, results: Mapping[int, BatchResult]) -> None:
    """Puts rendered clips into the dataset; a process killed meanwhile does it again.

    Args:
        adding: With all batches done.
        results: Of all batches.

    Raises:
        UserError: If a part is damaged, with its path.
        OSError: If the dataset cannot be written.
    """
    out, scaffold = adding.folder.path, adding.scaffold.path
    (scaffold / _MOVING).touch()
    parts = scaffold / "parts"
    done = {
        key
        for path in part_files(parts, "clips")
        if path.name.startswith("batch-")
        for key in read_table(path, ["scene_key"])["scene_key"].to_pylist()
    }
    for table in TABLES:
        for path in part_files(out, table):
            _keep(path, done, parts / table / f"kept-{path.name}")
    for path in sorted((scaffold / "clips").glob("[!.]*")):
        target = out / "clips" / path.name
        target.parent.mkdir(exist_ok=True)
        shutil.rmtree(target, ignore_errors=True)
        os.replace(path, target)
    sweep_clips(out / "clips")
    assemble_tables(parts, out, tables=TABLES, scenes=out)
    _tell(adding, results, done)
    shutil.rmtree(scaffold, ignore_errors=True)


def _keep(path: Path, done: set[str], kept: Path) -> None:
    """Rows of scenes that were not rendered anew, as a part; made once."""
    if kept.exists():
        return
    data = read_table(path)
    rows = [k for k, key in enumerate(data["scene_key"].to_pylist()) if key not in done]
    if rows:
        write_part(data.take(rows), kept)


def _tell(adding: Adding, results: Mapping[int, BatchResult], done: set[str]) -> None:
    """Failures, times, card and `meta/` of the dataset with its clips."""
    out = adding.folder.path
    new = [dict(row) for n in sorted(results) for row in results[n].failures]
    tried = {key.split("/")[2] for key in done} | {row["scene"] for row in new}
    failed = [
        row
        for row in failures_of(out)
        if row["outcome"] != NOT_RENDERED or row["scene"] not in tried
    ]
    _time(out / "meta" / "timings.json", results)
    write_json(out / PLAN, adding.spec.model_dump(mode="json"))
    describe_again(out, adding.spec, [*failed, *new])


def _time(path: Path, results: Mapping[int, BatchResult]) -> None:
    """Adds what rendering took to the times of a dataset."""
    times = json.loads(path.read_bytes())
    seconds = times["seconds"]
    for name in (RENDER, CROSSCHECK):
        spent = sum(r.seconds.get(name, 0.0) for r in results.values())
        seconds[name] = round(seconds.get(name, 0.0) + spent, 2)
    whole = sum(seconds.values())
    scenes = max(1, times["scenes"])
    times["seconds_per_scene"] = {k: round(v / scenes, 4) for k, v in seconds.items()}
    times["share"] = {k: round(v / whole, 4) if whole else 0.0 for k, v in seconds.items()}
    write_json(path, times)
