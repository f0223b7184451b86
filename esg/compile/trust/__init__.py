"""Whose class it is, and what a class may do that is not this process's own (docs/trust.md)."""
