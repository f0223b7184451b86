"""Worlds of many different scenes in one model and one launch."""
