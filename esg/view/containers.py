"""Where captured channels go: a file a picture, or rows of sharded Parquet; and back again."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
import json
from pathlib import Path
from typing import Any

from esg.view import png16
from esg.view.seeing import codes
from esg.view.seeing.wanted import PICTURES

ROWS_PER_SHARD = 512


class FileSink:
    """One PNG a picture: `camera_0/rgb/00000.png`; boxes and tracks as JSON lines."""

    def __init__(self, folder: Path) -> None:
        self._folder = folder
        self._lines: dict[Path, list[str]] = {}

    def add(self, camera: int, frame: int, time_s: float, row: dict[str, Any]) -> None:
        """Takes what one camera saw in one frame: encoded pictures, and values as JSON."""
        base = self._folder / f"camera_{camera}"
        for name, value in row.items():
            if isinstance(value, bytes):
                (base / name).mkdir(parents=True, exist_ok=True)
                (base / name / f"{frame:05d}.png").write_bytes(value)
            else:
                line = {"frame": frame, "time_s": round(time_s, 6), name: value}
                lines = self._lines.setdefault(base / f"{name}.jsonl", [])
                lines.append(json.dumps(line, separators=(",", ":"), allow_nan=False))

    def close(self) -> list[str]:
        """Writes what is left; returns the names of the shards, none for files."""
        for path, lines in self._lines.items():
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text("\n".join(lines) + "\n", encoding="utf-8")
        return []


class ParquetSink:
    """Rows of camera, frame, time and every channel; pictures are PNG bytes."""

    def __init__(self, folder: Path) -> None:
        self._folder = folder
        self._rows: list[dict[str, Any]] = []
        self._shards: list[Path] = []

    def add(self, camera: int, frame: int, time_s: float, row: dict[str, Any]) -> None:
        """Takes what one camera saw in one frame: encoded pictures, and values as JSON."""
        self._rows.append({"camera": camera, "frame": frame, "time_s": time_s, **row})
        if len(self._rows) == ROWS_PER_SHARD:
            self._flush()

    def close(self) -> list[str]:
        """Writes what is left; returns the names of the shards, none for files."""
        if self._rows:
            self._flush()
        names: list[str] = []
        for number, path in enumerate(self._shards):
            name = f"frames-{number:05d}-of-{len(self._shards):05d}.parquet"
            path.rename(self._folder / name)
            names.append(name)
        return names

    def _flush(self) -> None:
        import pyarrow as pa
        import pyarrow.parquet as pq

        path = self._folder / f"part-{len(self._shards):05d}.parquet"
        table = pa.Table.from_pylist(self._rows, schema=_schema(self._rows[0]))
        pq.write_table(table, path, compression="zstd", row_group_size=64)
        self._shards.append(path)
        self._rows = []


def _schema(row: dict[str, Any]) -> Any:
    import pyarrow as pa

    real, px = pa.list_(pa.float64()), pa.list_(pa.list_(pa.float64()))
    box_2d = {"id": pa.int32(), "box_px": pa.list_(pa.int32()), "visible_px": pa.int32()}
    box_3d = {
        "id": pa.int32(),
        "center_m": real,
        "half_extents_m": real,
        "quaternion_xyzw": real,
        "corners_px": px,
    }
    kinds: dict[str, Any] = {
        "camera": pa.int32(),
        "frame": pa.int32(),
        "time_s": pa.float64(),
        **{name: pa.binary() for name in PICTURES},
        "boxes2d": pa.list_(pa.struct(list(box_2d.items()))),
        "boxes3d": pa.list_(pa.struct(list(box_3d.items()))),
        "tracks": pa.struct([("xy_px", px), ("visible", pa.list_(pa.bool_()))]),
    }
    return pa.schema([(name, kinds[name]) for name in row])


def read_capture(folder: Path) -> Iterator[dict[str, Any]]:
    """Rows of a capture of either container, decoded: camera, frame, time_s and every channel.

    Depth comes in metres; the other pictures as their manifest says.

    Args:
        folder: Written by `capture`.
    """
    manifest = json.loads((folder / "manifest.json").read_bytes())
    channels = [c for c in manifest["channels"] if c in PICTURES]

    def pictures(camera: int, frame: int, data: Mapping[str, bytes]) -> dict[str, Any]:
        out = {c: png16.decode(data[c]) for c in channels}
        if "depth" in out:
            facts = manifest["cameras"][camera]
            offset, scale = facts["depth_offset"][frame], facts["depth_scale"][frame]
            out["depth"] = codes.depth_metres(out["depth"], offset, scale)
        return out

    if manifest["container"] == "parquet":
        import pyarrow.parquet as pq

        for name in manifest["shards"]:
            for batch in pq.ParquetFile(folder / name).iter_batches(64):
                for row in batch.to_pylist():
                    yield {**row, **pictures(row["camera"], row["frame"], row)}
        return
    for number in range(len(manifest["cameras"])):
        base = folder / f"camera_{number}"
        tables: dict[str, list[dict[str, Any]]] = {}
        for name in manifest["channels"]:
            if name not in PICTURES:
                lines = (base / f"{name}.jsonl").read_text(encoding="utf-8").splitlines()
                tables[name] = [json.loads(line) for line in lines]
        for frame, time_s in enumerate(manifest["time_s"]):
            row: dict[str, Any] = {"camera": number, "frame": frame, "time_s": time_s}
            row |= pictures(
                number,
                frame,
                {c: (base / c / f"{frame:05d}.png").read_bytes() for c in channels},
            )
            yield {**row, **{name: rows[frame][name] for name, rows in tables.items()}}
