"""The search for theta: strategies behind one interface, and what they share."""
