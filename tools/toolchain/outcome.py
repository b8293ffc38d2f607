# SPDX-License-Identifier: MIT
"""What tests come to."""

from __future__ import annotations

from dataclasses import dataclass, field


@dataclass
class Outcome:
    """Counts of a part of the tests, and what is to be said of it at the end."""

    passed: int = 0
    failed: int = 0
    notes: list[str] = field(default_factory=list)

    def add(self, other: Outcome) -> None:
        """Adds another part."""
        self.passed += other.passed
        self.failed += other.failed
        self.notes += other.notes
