"""Least, most, mean and spread of features, of an episode and of all, as LeRobot has them."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

Stats = dict[str, NDArray[Any]]
"""min, max, mean, std of a feature, and how many frames they are of (count)."""


def of_arrays(values: Mapping[str, NDArray[Any]]) -> dict[str, Stats]:
    """Statistics over the first axis, by feature."""
    return {name: _stats(array.reshape(len(array), -1)) for name, array in values.items()}


def of_film(path: Path) -> Stats:
    """Statistics of colours in [0, 1] over the key frames of a film, a number a channel."""
    import av

    frames: list[NDArray[Any]] = []
    with av.open(str(path)) as container:
        stream: Any = container.streams.video[0]
        stream.codec_context.skip_frame = "NONKEY"
        for frame in container.decode(stream):
            frames.append(frame.to_ndarray(format="rgb24").reshape(-1, 3))
    found = _stats(np.concatenate(frames) / 255.0)
    count = np.array([len(frames)])
    return {**{k: v.reshape(3, 1, 1) for k, v in found.items() if k != "count"}, "count": count}


def _stats(rows: NDArray[Any]) -> Stats:
    rows = rows.astype(np.float64)
    return {
        "min": rows.min(0), "max": rows.max(0), "mean": rows.mean(0), "std": rows.std(0),
        "count": np.array([len(rows)]),
    }  # fmt: skip


def flat(found: Mapping[str, Stats]) -> dict[str, Any]:
    """Columns of an episode's row."""
    return {
        f"stats/{feature}/{name}": values.tolist()
        for feature, stats in found.items()
        for name, values in stats.items()
    }


class Total:
    """Statistics of all episodes, of which it is told one after the other."""

    def __init__(self) -> None:
        self._sums: dict[str, dict[str, Any]] = {}

    def add(self, found: Mapping[str, Stats]) -> None:
        """Adds those of an episode."""
        for feature, s in found.items():
            n = s["count"][0]
            square = n * (s["std"] ** 2 + s["mean"] ** 2)
            if feature not in self._sums:
                self._sums[feature] = {
                    "min": s["min"], "max": s["max"], "count": n, "sum": n * s["mean"],
                    "square": square,
                }  # fmt: skip
                continue
            kept = self._sums[feature]
            kept["min"] = np.minimum(kept["min"], s["min"])
            kept["max"] = np.maximum(kept["max"], s["max"])
            kept["count"] += n
            kept["sum"] = kept["sum"] + n * s["mean"]
            kept["square"] = kept["square"] + square

    def stats(self) -> dict[str, Any]:
        """Of all, as JSON values."""
        out: dict[str, Any] = {}
        for feature, s in self._sums.items():
            mean = s["sum"] / s["count"]
            spread = np.sqrt(np.maximum(0.0, s["square"] / s["count"] - mean**2))
            out[feature] = {
                "min": s["min"].tolist(), "max": s["max"].tolist(), "mean": mean.tolist(),
                "std": spread.tolist(), "count": [int(s["count"])],
            }  # fmt: skip
        return out
