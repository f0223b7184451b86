"""Layout, events and constraints, measured on the replay."""

from __future__ import annotations

from tasks.batch import make_stage_task

judge_batch = make_stage_task("judge")
