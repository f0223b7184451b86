"""Kinds of energy terms, shared by the builder, the kernels and the predicates."""

BAND, DIRECTION, FACE, CENTER, UNDER, REGION, SLOT, BETWEEN, LERP = range(9)
