"""What the hub reads of a card: its metadata."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from esg.dataset.plan import DatasetSpec
from esg.store.assembling import SPLITS, Counts

_SIZES = (
    (1_000, "n<1K"), (10_000, "1K<n<10K"), (100_000, "10K<n<100K"), (1_000_000, "100K<n<1M"),
    (10_000_000, "1M<n<10M"),
)  # fmt: skip
_TASKS = {
    "rgb": ("text-to-video", "video-classification"),
    "depth": ("depth-estimation",),
    "segmentation": ("mask-generation",),
}
"""What a channel of clips can train."""


def header(title: str, spec: DatasetSpec, counts: Counts, facts: Mapping[str, Any]) -> str:
    """The YAML block of a card, with its fences."""
    from huggingface_hub import DatasetCardData

    seen = facts.get("clips") or {}
    tasks = [t for c, names in _TASKS.items() if c in seen.get("channels", ()) for t in names]
    if "questions" in facts:
        tasks.append("visual-question-answering" if seen else "question-answering")
    data = DatasetCardData(
        language=["en"],
        license="apache-2.0",
        license_name=None,
        annotations_creators=["machine-generated"],
        language_creators=["machine-generated" if spec.source == "sample" else "other"],
        source_datasets=["original"],
        task_categories=sorted(set(tasks)) or None,
        size_categories=[next((n for most, n in _SIZES if facts["scenes"] < most), "n>10M")],
        pretty_name=title,
        configs=_configs(counts),
        tags=["physics", "simulation", "synthetic", "3d", "dynamic-scenes", "esg"],
    )
    return f"---\n{data.to_yaml()}\n---"


def _configs(counts: Counts) -> list[dict[str, Any]]:
    out: list[dict[str, Any]] = []
    for name, by_split in counts.items():
        files = [
            {"split": split, "path": f"{name}/{split}-*.parquet"}
            for split in SPLITS
            if by_split.get(split)
        ]
        if name != "runs" and files:
            main = {"default": True} if name == "scenes" else {}
            out.append({"config_name": name, **main, "data_files": files})
    return out
