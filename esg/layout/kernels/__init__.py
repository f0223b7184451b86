"""Warp kernels of the layout search."""
