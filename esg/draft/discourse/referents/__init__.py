"""Referents: which object each noun phrase and pronoun means."""
