# SPDX-License-Identifier: MIT
"""The files of the repository."""

from __future__ import annotations

import subprocess

from .paths import ROOT


def tracked(*patterns: str) -> list[str]:
    """Files of the repository, also new ones, but not ignored ones."""
    command = ["git", "ls-files", "--cached", "--others", "--exclude-standard", "--", *patterns]
    done = subprocess.run(command, cwd=ROOT, capture_output=True, text=True, check=True)
    return sorted({name for name in done.stdout.split("\n") if name and (ROOT / name).exists()})
