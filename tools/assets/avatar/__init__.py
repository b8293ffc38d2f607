"""Tools that build the soldier avatar and what the game derives from it."""
