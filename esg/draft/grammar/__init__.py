"""Grammar: tokens become phrases, phrases become clauses."""
