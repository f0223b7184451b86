"""Prefect flows: what runs, in what order. Import `flows.embedded` before anything else here."""
