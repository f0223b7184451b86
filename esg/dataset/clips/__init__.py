"""Clips of a dataset: what cameras saw of its scenes (docs/dataset/clips.md)."""
