"""Rewrites: phrases put into plain order before clauses are built, one construction a module."""
