"""How many verified scenes an hour are made: `python -m benchmarks.throughput`."""
