"""Discourse: what has been read so far, and what references and times mean in it."""
