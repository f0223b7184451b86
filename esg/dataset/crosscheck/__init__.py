"""Ground truth of clips checked against geometry (docs/dataset/truth.md).

Nothing here knows how the truth was made: files are decoded by the formulas of the documentation,
cameras and bodies move by the poses of the tables, shapes come from the manifest, and the
arithmetic is its own. What made the truth (esg.view.truth, esg.view.seeing) is not imported.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from esg.dataset.crosscheck.running import check_batch, check_clips, check_dataset

__all__ = ["check_batch", "check_clips", "check_dataset"]


def __getattr__(name: str) -> object:
    if name in __all__:
        from esg.dataset.crosscheck import running

        return getattr(running, name)
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
