"""Casting: which bodies, sizes and supports the events of a prompt need."""
