"""Ten lines that load each layout of a dataset."""

from __future__ import annotations

from collections.abc import Mapping
import json
from pathlib import Path
from typing import Any

from esg.dataset.card.markdown import Lines

_TABLES = """
```python
from datasets import load_dataset

scenes = load_dataset("PATH", "scenes", split="train")
moves = load_dataset("PATH", "trajectories", split="train")  # join by scene_key
```
```sql
SELECT rule, avg(verified::INTEGER) FROM 'PATH/scenes/*.parquet' GROUP BY rule -- DuckDB
```
```python
import polars as pl

pl.scan_parquet("PATH/scenes/*.parquet")
```
""".strip()

_CLIPS = """
```python
import av, numpy as np, pyarrow.parquet as pq

clip = pq.read_table("PATH/clips", filters=[("split", "=", "train")]).slice(0, 1).to_pylist()[0]
path = {f["channel"]: "PATH/" + f["path"] for f in clip["files"]}
frames = lambda c: np.stack([f.to_ndarray() for f in av.open(path[c]).decode(video=0)])
rgb = np.stack([f.to_ndarray(format="rgb24") for f in av.open(path["rgb"]).decode(video=0)])
```
""".strip()

_DECODED = {
    "depth": (
        'code, at = frames("depth"), (slice(None), None, None)',
        'logs = np.array(clip["depth_offset"])[at] + np.array(clip["depth_scale"])[at] * code',
        "metres = np.exp(logs) * (code > 0)  # 0: nothing",
    ),
    "flow": (
        'code = frames("flow").astype(float)  # third plane: 65535 where known',
        'shift_px = (code[..., :2] - 32768) * np.array(clip["flow_scale"])[:, None, None, None]',
    ),
    "segmentation": ('ids = frames("segmentation")  # 0 nothing, 1 ground, else objects[k]["id"]',),
}

_LAYOUTS = {
    "webdataset": """
```python
import webdataset as wds

shards = "PATH/layouts/webdataset/train-{000000..000000}.tar"  # as many as there are
for sample in wds.WebDataset(shards, shardshuffle=False):
    video, facts = sample["rgb.mp4"], sample["json"]  # bytes; .npz has the arrays a frame
```
""".strip(),
    "lerobot": """
```python
from lerobot.datasets.lerobot_dataset import LeRobotDataset

episodes = LeRobotDataset("esg/scenes", root="PATH/layouts/lerobot")  # an episode a clip
frame = episodes[0]
```
""".strip(),
    "movi": """
```python
import glob, numpy as np

for path in sorted(glob.glob("PATH/layouts/movi/**/*.npz", recursive=True)):
    clip = np.load(path, allow_pickle=False)  # MOVi's fields
```
""".strip(),
}


def present(out: Path) -> tuple[str, ...]:
    """Layouts that a dataset has or will have, besides its tables."""
    wanted: set[str] = {p.parent.name for p in out.glob("layouts/*/layout.json")}
    path = out / "meta" / "layouts.json"
    if path.is_file():
        found = json.loads(path.read_bytes())
        wanted |= set(found if isinstance(found, list) else found.get("layouts", ()))
    return tuple(name for name in _LAYOUTS if name in wanted)


def recipes(facts: Mapping[str, Any]) -> Lines:
    """How to read what the dataset has; PATH is its folder or its name on the hub."""
    lines = ["**Tables** (`datasets`, DuckDB, Polars):", "", *_TABLES.splitlines(), ""]
    channels = (facts.get("clips") or {}).get("channels", ())
    if "rgb" in channels:
        code = _CLIPS.splitlines()
        decoded = [line for name in _DECODED if name in channels for line in _DECODED[name]]
        lines += ["**Clips** (PyAV, NumPy):", "", *code[:-1], *decoded, code[-1], ""]
    for name in facts.get("layouts", ()):
        lines += [f"**{name}**:", "", *_LAYOUTS[name].splitlines(), ""]
    return lines
