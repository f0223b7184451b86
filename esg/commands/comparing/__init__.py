"""Commands that set systems, variants and people beside each other."""
