"""Leave-one-out pruning of a package of rules: units, effects, choice, rewriting, dead code."""
