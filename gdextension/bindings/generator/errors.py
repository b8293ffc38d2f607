# SPDX-License-Identifier: MIT
"""The two ways in which generating can go wrong."""

from __future__ import annotations


class GeneratorError(Exception):
    """Wrong input: its message is all that the user gets to see."""


class UnsupportedType(Exception):
    """A type that cannot be bound, or that the build profile leaves out: its member is skipped."""
