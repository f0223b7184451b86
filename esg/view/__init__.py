"""Seeing results: still renders (`esg.view.render`) and contact sheets (`esg.view.preview`)."""
