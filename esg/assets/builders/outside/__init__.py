"""Builders of what is found out of doors: ground, plants, structures, large machines."""
