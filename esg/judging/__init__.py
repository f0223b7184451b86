"""Anybody's motion before the judge: poses of a file become a replay (docs/judging.md)."""
