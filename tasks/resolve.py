"""Stage 2: requirements to assets."""

from __future__ import annotations

from tasks.batch import make_stage_task

resolve_batch = make_stage_task("resolve")
