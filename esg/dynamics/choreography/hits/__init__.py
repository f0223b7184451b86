"""Hits: how hard one must be, what it passes on, rows of them, and bounces off a third thing."""
