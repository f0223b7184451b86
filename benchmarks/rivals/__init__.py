"""The paper's rivals on our bench: what they make is compiled, replayed and judged as our own."""
