"""WebDataset: tar files of clips, a sample a clip, for readers that stream.

A sample `<scene>_camera_<k>` has `.json` (esg.dataset.layouts.described), `.npz` (arrays a frame),
`.rgb.mp4` and a `.<channel>.mkv` for every other channel: the files of the dataset as they are.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from functools import partial
import io
import json
from pathlib import Path
import tarfile
from typing import Any

from esg.dataset.layouts.building import LayoutFolder
from esg.dataset.layouts.described import TABLES, archive, arrays, document
from esg.dataset.layouts.source import Sample, Source, splits

SHARD = "{split}-{index:06d}.tar"
SHARD_BYTES = 256 * 2**20
"""Size that a shard aims to stay under: what a loader reads ahead."""
SHARD_CLIPS = 500


def write(source: Source, folder: LayoutFolder) -> dict[str, Any]:
    """Writes all shards; returns how many samples and shards every split has."""
    counts: dict[str, dict[str, int]] = {}
    for split in splits():
        counts[split] = {"samples": 0, "shards": 0}
        for index, samples in enumerate(_shards(source.samples(split, TABLES))):
            name = SHARD.format(split=split, index=index)
            folder.add(name, partial(_tar, samples))
            counts[split] = {
                "samples": counts[split]["samples"] + len(samples),
                "shards": index + 1,
            }
    return {"splits": counts}


def _shards(samples: Iterator[Sample]) -> Iterator[list[Sample]]:
    shard: list[Sample] = []
    size = 0
    for sample in samples:
        weight = sum(file.bytes for file in sample.clip.record.files)
        if shard and (size + weight > SHARD_BYTES or len(shard) >= SHARD_CLIPS):
            yield shard
            shard, size = [], 0
        shard.append(sample)
        size += weight
    if shard:
        yield shard


def _tar(samples: Sequence[Sample], path: Path) -> None:
    with tarfile.open(path, "w", format=tarfile.GNU_FORMAT) as tar:
        for sample in samples:
            text = json.dumps(document(sample), sort_keys=True, ensure_ascii=False)
            _add(tar, f"{sample.key}.json", text.encode())
            _add(tar, f"{sample.key}.npz", archive(arrays(sample), packed=True))
            for file in sample.clip.record.files:
                place = sample.clip.path(file.channel)
                _add(tar, f"{sample.key}.{file.channel}{place.suffix}", place.read_bytes())


def _add(tar: tarfile.TarFile, name: str, data: bytes) -> None:
    """A file without owner and time: they would tell where and when, not what."""
    entry = tarfile.TarInfo(name)
    entry.size, entry.mode = len(data), 0o644
    tar.addfile(entry, io.BytesIO(data))
