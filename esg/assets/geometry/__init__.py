"""Meshes, collision proxies, signed distance fields and what follows from shapes."""
