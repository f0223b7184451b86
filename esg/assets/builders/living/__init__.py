"""Builders of people, animals and figures in their shape."""
