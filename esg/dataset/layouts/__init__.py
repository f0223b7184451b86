"""Layouts: a finished dataset again, in the files that training code reads (docs/dataset/layouts.md).

`registry` has them by name, `building` writes them, `source` is what they are written from.
"""
