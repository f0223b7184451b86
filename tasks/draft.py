"""Stage 1: prompt to ESG draft, with its violations."""

from __future__ import annotations

from tasks.batch import make_stage_task

draft_batch = make_stage_task("draft")
