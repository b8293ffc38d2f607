# SPDX-License-Identifier: MIT
"""Follows docs/tutorial.md in the real editor, by keyboard and mouse, and takes its pictures.

    python -m tutorial [FOLDER]     (with the test tools' Python and PYTHONPATH=tools)

`tests/system/test_editor.py` follows the same steps.
"""
