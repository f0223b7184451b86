"""The place around the action, clear of what the replay shows."""

from __future__ import annotations

from tasks.batch import make_stage_task

dress_batch = make_stage_task("dress")
