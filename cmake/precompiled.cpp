// Nothing: CMake builds a precompiled header for sources alone.
