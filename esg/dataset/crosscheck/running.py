"""Checks of a sample of clips: rows of table `truth_checks`."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
import hashlib
import json
from pathlib import Path
from typing import Any

import numpy as np

from esg.dataset.clips.reading import Clip, read_clips
from esg.dataset.crosscheck import contacts
from esg.dataset.crosscheck.checks import CHECKS, Residuals
from esg.dataset.crosscheck.frames import Floats, Seen
from esg.store.tables import part_files

SHARE = 0.1
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
    keys = sorted({r["scene_key"] for r in _some(files, ["scene_key"])})
    if most is not None and len(keys) > most:
        keys = sampled(keys, most / len(keys))
    base = folder if part_files(folder, "scenes") else folder / "parts"
    wanted = set(keys)
    clips: list[Clip] = []
    for clip in read_clips(folder):
        if clip.record.scene_key not in wanted:
            continue
        if clips and clips[0].record.scene_key != clip.record.scene_key:
            yield from _scene(base, clips)
            clips = []
        clips.append(clip)
    if clips:
        yield from _scene(base, clips)


def _scene(base: Path, clips: list[Clip]) -> list[dict[str, Any]]:
    key = clips[0].record.scene_key
    scenes = {r["scene_key"]: r for r in _rows_of(base, "scenes", key)}
    replays = {r["scene_key"]: r for r in _rows_of(base, "trajectories", key)}
    return check_clips(clips, scenes, replays)


def _rows_of(base: Path, table: str, key: str) -> list[dict[str, Any]]:
    import pyarrow.parquet as pq

    out: list[dict[str, Any]] = []
    for path in part_files(base, table):
        out += pq.read_table(path.absolute(), filters=[("scene_key", "==", key)]).to_pylist()
    return out


def _some(files: Iterable[Path], columns: list[str]) -> Iterator[dict[str, Any]]:
    from esg.store.tables import iter_batches

    for batch in iter_batches(files, columns):
        yield from batch.to_pylist()


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
