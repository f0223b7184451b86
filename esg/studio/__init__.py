"""`esg studio`: a page on this machine on which scenes are written, solved and played."""
