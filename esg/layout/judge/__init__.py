"""Exact judgement of layouts, and which of them becomes the scene."""
