"""Exports opened in Blender and three.js: `python -m benchmarks.looks`."""
