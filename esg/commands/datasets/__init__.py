"""`esg dataset`, and what it takes beside the scenes: cameras, layouts, what is drawn."""
