"""What scenes cost: processor time by stage, of runs that were made and of runs to come."""
