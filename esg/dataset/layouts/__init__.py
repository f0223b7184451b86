"""Layouts: a finished dataset again, as training code reads it (docs/dataset/layouts.md).

`registry` has them by name, `building` writes them, `source` is what they are written from.
"""
