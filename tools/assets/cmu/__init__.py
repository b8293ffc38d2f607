"""Tools that make motion files of Carnegie Mellon's library."""
