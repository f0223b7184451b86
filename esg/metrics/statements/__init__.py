"""What a prompt states beyond its events, measured on a replay (docs/metrics/statements.md)."""
