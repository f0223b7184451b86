"""Unreal C++ that every emitted class is played with: `EsgScene.h` and `EsgScene.cpp`."""
