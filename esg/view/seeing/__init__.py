"""What is rendered, what cameras see of it, and how that is told in whole numbers."""
