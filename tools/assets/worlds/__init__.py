"""Makes the worlds."""
