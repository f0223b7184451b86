"""What this machine offers a scene: a cache between processes, a second core."""
