"""Clauses: who does what to whom, in which order."""
