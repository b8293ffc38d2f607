# SPDX-License-Identifier: MIT
"""Everything behind `./run` and `./test`: set-up, build, export, roles, demo, tests.

Python's standard library only, so that a bare machine needs no package for it.
"""
