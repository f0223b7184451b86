"""The same scene again: unchanged in other engines and at other steps, and with one thing changed.

`worlds` makes the changed scenes, `replaying` plays them, `outcomes` says what became of their
events, `statistics` adds up a dataset (docs/dataset/whatifs.md).
"""

from __future__ import annotations

from esg.dataset.whatifs.statistics import what_if_statistics

__all__ = ["what_if_statistics"]
