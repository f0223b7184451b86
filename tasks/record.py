"""Meshes, MCAP and the contact sheet."""

from __future__ import annotations

from tasks.batch import make_stage_task

record_batch = make_stage_task("record")
