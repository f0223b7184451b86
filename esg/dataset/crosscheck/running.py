"""Checks of a sample of clips: rows of table `truth_checks`."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
import hashlib
import json
from pathlib import Path
from typing import Any

import numpy as np

from esg.dataset.clips.reading import Clip, read_clips
from esg.dataset.clips.records import ClipRecord
from esg.dataset.crosscheck import contacts
from esg.dataset.crosscheck.checks import CHECKS, Residuals
from esg.dataset.crosscheck.frames import Floats, Seen
from esg.store.tables import iter_rows, part_files, to_table, write_part

SHARE = 0.05
"""Of the scenes of a batch, at least one."""
STEPS = 6
"""Places in a clip at which two successive frames are looked at."""
NO_CAMERA = -1
"""Camera of checks of the replay."""


def sampled(keys: Iterable[str], share: float = SHARE) -> list[str]:
    """Scenes to be checked: the same whoever asks, in the order of their keys.

    Args:
        keys: Of scenes; of a batch, so that every batch is checked.
        share: Of them; at least one.
    """
    ordered = sorted(set(keys), key=lambda key: (_digest(key), key))
    return sorted(ordered[: max(1, round(share * len(ordered)))] if ordered else [])


def check_batch(
    out: Path, clips: Iterable[Mapping[str, Any]], name: str, told: Mapping[str, Sequence[Path]]
) -> Path | None:
    """Checks a sample of a batch's scenes and writes the part of table `truth_checks`.

    Args:
        out: Folder that the clips and the parts are below.
        clips: Rows of table `clips` of the batch.
        name: Of the part, without suffix.
        told: Files of the tables `scenes` and `trajectories` that tell its scenes.

    Returns:
        The part; None if nothing could be checked.

    Raises:
        OSError: If it cannot be written.
    """
    by_scene: dict[str, list[Clip]] = {}
    for row in clips:
        record = ClipRecord.of(row)
        by_scene.setdefault(record.scene_key, []).append(Clip(out, record))
    rows = [row for key in sampled(by_scene) for row in _scene(told, by_scene[key])]
    if not rows:
        return None
    path = out / "parts" / "truth_checks" / f"{name}.parquet"
    write_part(to_table("truth_checks", rows), path)
    return path


def check_clips(
    clips: Iterable[Clip],
    scenes: Mapping[str, Mapping[str, Any]],
    replays: Mapping[str, Mapping[str, Any]],
) -> list[dict[str, Any]]:
    """Rows of table `truth_checks` of some clips and of the replays they show.

    Args:
        clips: All of a scene, one scene after another.
        scenes: Rows of table `scenes` by key: their manifests.
        replays: Rows of table `trajectories` by key.

    Raises:
        UserError: If a file of a clip is missing or damaged.
    """
    out: list[dict[str, Any]] = []
    told: set[str] = set()
    for clip in clips:
        key = clip.record.scene_key
        manifest = json.loads(scenes[key]["manifest"] or "{}") if key in scenes else {}
        if key not in told and key in replays and manifest:
            told.add(key)
            out.append(_replay_row(clip, replays[key], manifest))
        out += list(_clip_rows(clip, manifest))
    return out


def check_dataset(folder: Path, *, most: int | None = None) -> Iterator[dict[str, Any]]:
    """Rows of `check_clips` of a dataset, scene by scene.

    Args:
        folder: Of the dataset, finished or not.
        most: Scenes at most, drawn by their keys; None for all.
    """
    files = part_files(folder, "clips") or part_files(folder / "parts", "clips")
    keys = sorted({r["scene_key"] for r in iter_rows(files, ["scene_key"])})
    if most is not None and len(keys) > most:
        keys = sampled(keys, most / len(keys))
    base = folder if part_files(folder, "scenes") else folder / "parts"
    told = {table: part_files(base, table) for table in ("scenes", "trajectories")}
    wanted = set(keys)
    clips: list[Clip] = []
    for clip in read_clips(folder):
        if clip.record.scene_key not in wanted:
            continue
        if clips and clips[0].record.scene_key != clip.record.scene_key:
            yield from _scene(told, clips)
            clips = []
        clips.append(clip)
    if clips:
        yield from _scene(told, clips)


def _scene(told: Mapping[str, Sequence[Path]], clips: list[Clip]) -> list[dict[str, Any]]:
    """Rows of one scene; one that cannot be checked has a row that says so, and fails."""
    key = clips[0].record.scene_key
    try:
        found = {
            table: {row["scene_key"]: row for row in _rows_of(files, table, key)}
            for table, files in told.items()
        }
        return check_clips(clips, found["scenes"], found["trajectories"])
    except Exception as error:  # whatever is wrong with its files: the others are checked
        row = _row(clips[0], NO_CAMERA, "readable", ("", 0.0), Residuals.joined([]))
        return [{**row, "ok": False, "note": f"{type(error).__name__}: {error}"}]


_COLUMNS = {
    "scenes": ["scene_key", "manifest"],
    "trajectories": [
        "scene_key", "bodies", "n_frames", "time_s", "position_m", "quaternion_xyzw",
        "linear_velocity_mps", "angular_velocity_radps", "contact_time_s", "contact_a",
        "contact_b",
    ],
}  # fmt: skip


def _rows_of(files: Iterable[Path], table: str, key: str) -> list[dict[str, Any]]:
    import pyarrow.parquet as pq

    wanted = [("scene_key", "==", key)]
    found = (pq.read_table(p.absolute(), columns=_COLUMNS[table], filters=wanted) for p in files)
    return [row for data in found for row in data.to_pylist()]


def _digest(text: str) -> int:
    return int.from_bytes(hashlib.sha256(text.encode()).digest()[:8], "big")


def _clip_rows(clip: Clip, manifest: Mapping[str, Any]) -> Iterator[dict[str, Any]]:
    record = clip.record
    seen = Seen(clip.folder, record, _frames(record.n_frames), _wheels(clip, manifest))
    for name, check in CHECKS.items():
        if check.applies(seen):
            rng = np.random.default_rng(_digest(f"{record.scene_key}/{record.camera}/{name}"))
            found = check.run(seen, rng)
            yield _row(clip, record.camera, name, (check.unit, check.limit), found)


def _replay_row(
    clip: Clip, replay: Mapping[str, Any], manifest: Mapping[str, Any]
) -> dict[str, Any]:
    rng = np.random.default_rng(_digest(f"{clip.record.scene_key}/contacts"))
    found = contacts.contact_gaps(replay, manifest, rng)
    limit = (contacts.UNIT, contacts.LIMIT_M)
    return _row(clip, NO_CAMERA, "contacts", limit, found)


def _frames(n: int) -> tuple[int, ...]:
    """Pairs of successive frames, spread over a clip of n."""
    first = np.unique(np.linspace(0, max(0, n - 2), STEPS).round().astype(int))
    return tuple(sorted({int(k) for k in first} | {int(k) + 1 for k in first if k + 1 < n}))


def _wheels(clip: Clip, manifest: Mapping[str, Any]) -> dict[int, list[tuple[Floats, float]]]:
    bodies = {b["name"]: b.get("wheels", ()) for b in manifest.get("bodies", ())}
    return {
        o.id: [(np.array(w["axle"], float), float(w["radius"])) for w in bodies[o.name]]
        for o in clip.record.objects
        if bodies.get(o.name)
    }


def _row(
    clip: Clip, camera: int, name: str, limit: tuple[str, float], found: Residuals
) -> dict[str, Any]:
    record = clip.record
    values = found.values
    percent = np.percentile(values, (50, 90, 99, 100)) if len(values) else [None] * 4
    note = ""
    if len(values):
        frame, number = (int(v) for v in found.where[int(np.argmax(values))])
        what = {o.id: o.name for o in record.objects}.get(number, "the ground")
        note = f"worst at frame {frame}, {what}" if camera != NO_CAMERA else f"frame {frame}"
    numbers = [None if p is None else float(p) for p in percent]
    return {
        **{k: getattr(record, k) for k in ("run_id", "scene_key", "suite", "scene_id", "seed")},
        "prompt": record.prompt,
        "camera": camera,
        "check_name": name,
        "unit": limit[0],
        "samples": len(values),
        **dict(zip(("p50", "p90", "p99", "worst"), numbers, strict=True)),
        "limit_value": limit[1],
        "ok": None if numbers[2] is None else bool(numbers[2] <= limit[1]),
        "note": note,
    }
