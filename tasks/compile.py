"""Stage 5: the engine-executable scene."""

from __future__ import annotations

from tasks.batch import make_stage_task

compile_batch = make_stage_task("compile")
