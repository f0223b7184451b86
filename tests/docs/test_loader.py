"""docs/dataset/loader.py, and a small network that every layout trains."""

from __future__ import annotations

from collections.abc import Callable, Iterator
import importlib.util
import io
from pathlib import Path
import tarfile
import time
from typing import Any

import av
import numpy as np
import pyarrow.parquet as pq
import pytest

from esg.dataset.layouts.building import add_layouts
from esg.dataset.layouts.registry import LAYOUTS
from tests.dataset.layouts.sets import FRAMES, SIZE, make_set

torch = pytest.importorskip("torch", reason="PyTorch is not installed")
TRAINED_S = 60.0


@pytest.fixture(scope="module")
def loader() -> Any:
    path = Path(__file__).parents[2] / "docs" / "dataset" / "loader.py"
    spec = importlib.util.spec_from_file_location("loader", path)
    assert spec is not None and spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


@pytest.fixture(scope="module")
def made(tmp_path_factory: pytest.TempPathFactory) -> Path:
    out = make_set(tmp_path_factory.mktemp("sets") / "made")
    add_layouts(out, LAYOUTS, print)
    return out


def test_the_loader_gives_frames_ids_and_prompts(loader, made):
    clips = loader.Clips(made, length=4)
    assert len(clips) == 6
    item = clips[0]
    assert item["rgb"].shape == (4, 3, SIZE[1], SIZE[0])
    assert item["prompt"] == "Ball 0 of scene 0000000 hits ball 2."
    red = item["rgb"][:, 0] - item["rgb"][:, 1]
    assert red[item["ids"] == 2].mean() > 0.2 > red[item["ids"] != 2].mean() + 0.1
    batch = next(iter(torch.utils.data.DataLoader(clips, batch_size=3)))
    assert batch["ids"].shape == (3, 4, SIZE[1], SIZE[0])


def of_parquet(loader: Any, made: Path) -> Iterator[Any]:
    return loader.endless(torch.utils.data.DataLoader(loader.Clips(made, length=4), batch_size=2))


def decoded(data: bytes, kind: str | None) -> np.ndarray:
    with av.open(io.BytesIO(data)) as film:
        return np.stack([f.to_ndarray(format=kind) for f in film.decode(video=0)])


def tensors(rgb: np.ndarray, ids: np.ndarray) -> tuple[Any, Any]:
    pictures = torch.from_numpy(rgb).permute(0, 3, 1, 2).float() / 255
    return pictures, torch.from_numpy(ids.astype(np.int64))


def of_webdataset(loader: Any, made: Path) -> Iterator[Any]:
    while True:
        for path in sorted((made / "layouts" / "webdataset").glob("train-*.tar")):
            with tarfile.open(path) as tar:
                files = {m.name: tar.extractfile(m).read() for m in tar}  # type: ignore[union-attr]
            for name, data in files.items():
                if name.endswith(".rgb.mp4"):
                    ids = files[name.replace(".rgb.mp4", ".segmentation.mkv")]
                    yield tensors(decoded(data, "rgb24"), decoded(ids, None))


def of_movi(loader: Any, made: Path) -> Iterator[Any]:
    while True:
        for path in sorted((made / "layouts" / "movi" / "train").glob("*.npz")):
            with np.load(path) as sample:
                yield tensors(sample["video"], 1 + sample["segmentations"][..., 0])


def of_lerobot(loader: Any, made: Path) -> Iterator[Any]:
    """It has no segmentation: the body is where a frame is red."""
    root = made / "layouts" / "lerobot"
    rows = pq.read_table(root / "data" / "chunk-000" / "file-000.parquet").num_rows
    path = root / "videos" / "observation.images.rgb" / "chunk-000" / "file-000.mp4"
    frames = decoded(path.read_bytes(), "rgb24")
    assert len(frames) == rows
    while True:
        for k in range(0, rows, FRAMES):
            rgb = frames[k : k + FRAMES]
            red = rgb[..., 0].astype(int) - rgb[..., 1] > 50
            yield tensors(rgb, np.where(red, 2, 1))


READERS: dict[str, Callable[[Any, Path], Iterator[Any]]] = {
    "parquet": of_parquet, "webdataset": of_webdataset, "movi": of_movi, "lerobot": of_lerobot,
}  # fmt: skip


def for_a_while(batches: Iterator[Any], seconds: float) -> Iterator[Any]:
    end = time.monotonic() + seconds
    while time.monotonic() < end:
        yield next(batches)


@pytest.mark.slow
@pytest.mark.parametrize("layout", READERS)
def test_every_layout_trains_a_small_network_for_a_minute(layout, loader, made):
    torch.manual_seed(0)
    batches = for_a_while(READERS[layout](loader, made), TRAINED_S)
    losses = loader.train(batches, 10**9)
    assert len(losses) > 20
    assert np.mean(losses[-5:]) < 0.5 * losses[0]
