"""What must hold when something breaks: damaged input and data, killed and interrupted work."""
