# SPDX-License-Identifier: MIT
"""The helper of `--source=webcam`: pictures of a camera or a film in, landmarks of people out."""
