"""Pictures of an exported scene in a browser: `python -m benchmarks.glb_viewer`."""
