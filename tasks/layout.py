"""Stage 3: poses."""

from __future__ import annotations

from tasks.batch import make_stage_task

layout_batch = make_stage_task("layout")
