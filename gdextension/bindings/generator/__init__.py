# SPDX-License-Identifier: MIT
"""Generates C++ bindings for the engine classes of a build profile from the engine's own dump."""
