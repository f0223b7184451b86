"""The paper's ablations as runs of the whole pipeline with something left out."""
