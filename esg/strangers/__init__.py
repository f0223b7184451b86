"""Files that somebody else may have made: what they may be, checked before they are opened."""
