# SPDX-License-Identifier: MIT
"""The gate for what the engine warns of in scripts."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from pathlib import Path
from tempfile import TemporaryDirectory

import pytest
from toolchain import script_warnings
from toolchain.godot import find
from toolchain.paths import BUILD, ROOT, make_folder

FINE = "extends RefCounted\n\n\nfunc sum(p_one: int, p_two: int) -> int:\n\treturn p_one + p_two\n"
Judge = Callable[[str], str]


@pytest.fixture
def judge() -> Iterator[Judge]:
    """What the gate finds in a script of this text."""
    with TemporaryDirectory(dir=make_folder(BUILD)) as folder:
        script = Path(folder) / "script.gd"

        def find_in(text: str) -> str:
            script.write_text(text, encoding="utf-8")
            return script_warnings.find(find(), [str(script.relative_to(ROOT))])

        yield find_in


def test_a_sound_script_passes(judge: Judge) -> None:
    assert judge(FINE) == ""


def test_a_name_of_a_built_in_function_is_found(judge: Judge) -> None:
    found = judge(FINE + "\n\nfunc half() -> float:\n\tvar round: float = 0.5\n\treturn round\n")
    assert 'The variable "round" has the same name as a built-in function' in found
    assert "script.gd:9" in found


def test_a_script_that_does_not_compile_is_found(judge: Judge) -> None:
    assert "Parse Error" in judge(FINE + "\n\nfunc broken() -> void:\n\tpass this\n")


def test_a_script_that_is_gone_is_found() -> None:
    assert script_warnings.find(find(), ["scripts/there_is_none.gd"]) != ""
