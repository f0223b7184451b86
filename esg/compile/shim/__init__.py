"""C++ headers under which an emitted class compiles and runs without Unreal."""
