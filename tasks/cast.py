"""Between resolve and layout: the bodies that the prompt leaves open and its events need."""

from __future__ import annotations

from tasks.batch import make_stage_task

cast_batch = make_stage_task("cast")
