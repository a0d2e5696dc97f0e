"""Independent oracles for the engine: slow, plain, and sharing no code with it."""
