"""Events: what clauses tell, as motions, point events and relations of a scene."""
