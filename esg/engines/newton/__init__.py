"""The reference engine: Newton's Steel solver."""
