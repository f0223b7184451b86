"""Documents: what a scene implies but does not say, and the scene as an ESG document."""
