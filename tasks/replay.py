"""The emitted scene, executed in the verify engine."""

from __future__ import annotations

from tasks.batch import make_stage_task

replay_batch = make_stage_task("replay")
