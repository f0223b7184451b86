"""Scene-independent C++ of an emitted class; `@CLASS@` stands for its name."""
