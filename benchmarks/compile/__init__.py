"""How fast emitted classes are compiled and replayed, and whether exports are whole."""
