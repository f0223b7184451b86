"""Prefect tasks: one a stage; batches of scene states in and out, data by artifact key."""

from __future__ import annotations

from importlib import import_module
from typing import Any

from esg.pipeline import STAGES


def stage_task(stage: str) -> Any:
    """The Prefect task of a stage.

    Args:
        stage: One of `esg.pipeline.STAGES`.
    """
    if stage not in STAGES:
        raise ValueError(f"unknown stage {stage!r}; stages are {', '.join(STAGES)}")
    return getattr(import_module(f"tasks.{stage}"), f"{stage}_batch")
