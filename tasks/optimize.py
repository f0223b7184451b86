"""Stage 4: theta and the control program."""

from __future__ import annotations

from tasks.batch import make_stage_task

optimize_batch = make_stage_task("optimize")
