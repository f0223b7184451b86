"""A clip as one JSON document and one archive of arrays: all that its pictures do not say."""

from __future__ import annotations

from collections.abc import Mapping
import datetime
import io
import math
from typing import Any
import zipfile

import numpy as np
from numpy.typing import NDArray

from esg.dataset.layouts.source import Sample
from esg.store.tables import COLUMNS

TABLES = tuple(
    name
    for name in ("metrics", "statements", "captions", "questions", "engine_events", "what_ifs")
    if name in COLUMNS
)
"""Whose rows of the scene go along; in documents `metrics` are called events."""

_COMMON = frozenset({"run_id", "scene_key", "suite", "scene_id", "seed", "prompt", "strategy"})
_OF_SCENE = (
    "outcome", "verified", "plausible", "fully_understood", "statements_kept", "engines_agree",
    "level", "rule", "pair", "changed", "parameters", "family",
)  # fmt: skip
_OF_CLIP = (
    "scene_key", "scene_id", "seed", "split", "prompt", "camera", "camera_kind", "width", "height",
    "fps", "n_frames", "renderer", "samples", "channels",
)  # fmt: skip
_ARRAYS = (
    "time_s", "camera_position_m", "camera_quaternion_xyzw", "object_bounds_m",
    "object_position_m", "object_quaternion_xyzw", "depth_offset", "depth_scale", "flow_scale",
    "backward_flow_scale", "track_ids", "track_point_m", "track_xy_px", "track_visible",
)  # fmt: skip


def document(sample: Sample) -> dict[str, Any]:
    """What is known of a clip and its scene but for arrays, as JSON values."""
    record, scene = sample.clip.record, sample.scene
    tables = {
        "events" if table == "metrics" else table: [_plain(row) for row in rows]
        for table, rows in sample.more.items()
        if table in TABLES and rows
    }
    return {
        **{name: getattr(record, name) for name in _OF_CLIP},
        **{name: scene[name] for name in _OF_SCENE if name in scene},
        "intrinsics": vars(record.intrinsics),
        "objects": [vars(o) for o in record.objects],
        "boxes2d": list(record.boxes2d),
        "boxes3d": [{k: _value(v) for k, v in box.items()} for box in record.boxes3d],
        **tables,
    }


def _plain(row: Mapping[str, Any]) -> dict[str, Any]:
    return {k: _value(v) for k, v in row.items() if k not in _COMMON and v is not None}


def _value(value: Any) -> Any:
    if isinstance(value, float) and not math.isfinite(value):
        return None
    if isinstance(value, datetime.datetime):
        return value.isoformat()
    return value


def arrays(sample: Sample) -> dict[str, NDArray[Any]]:
    """Arrays of a clip by the names of their columns, with their shapes (esg.dataset.clips)."""
    found = {name: np.asarray(getattr(sample.clip.record, name)) for name in _ARRAYS}
    return {name: values for name, values in found.items() if values.size}


def archive(values: Mapping[str, NDArray[Any]], *, packed: bool = False) -> bytes:
    """Arrays as a NumPy archive (.npz); equal arrays give equal bytes.

    Args:
        values: The arrays by name; a name may have folders.
        packed: Whether to compress.
    """
    out = io.BytesIO()
    kind = zipfile.ZIP_DEFLATED if packed else zipfile.ZIP_STORED
    with zipfile.ZipFile(out, "w", kind, compresslevel=1 if packed else None) as file:
        for name, array in values.items():
            entry = zipfile.ZipInfo(f"{name}.npy")  # as of 1980, whenever it is
            entry.compress_type = kind
            with file.open(entry, "w", force_zip64=True) as target:
                np.lib.format.write_array(target, np.asarray(array, order="C"), allow_pickle=False)
    return out.getvalue()
