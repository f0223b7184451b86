"""Builders of balls, sports equipment and games."""
