"""The catalogue of the parametric library and the ways to find an entry in it."""
