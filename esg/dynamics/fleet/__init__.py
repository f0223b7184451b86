"""Many scenes searched at once, whose rollouts share every launch of the engines."""
