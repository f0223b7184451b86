"""Traces and numbers of a run, off unless the environment asks for them."""
