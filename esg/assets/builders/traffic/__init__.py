"""Builders of what drives, sails, flies and stands along roads."""
