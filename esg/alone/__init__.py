"""One scene by itself: stages as plain functions, without a scheduler."""
