"""Builders of what stands and lies in houses."""
