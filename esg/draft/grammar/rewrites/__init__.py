"""Rewrites: phrases put into plain order before clauses are built, most by rows of a table."""
