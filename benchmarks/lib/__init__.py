"""What several benchmarks share; each command itself is a module of `benchmarks`."""
