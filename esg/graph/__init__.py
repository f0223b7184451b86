"""The ESG document: models, verifier, canonical JSON and hash, JSON Schema."""
