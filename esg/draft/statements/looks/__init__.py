"""What statements say of how things look: worn, drawn on them, filled with."""
