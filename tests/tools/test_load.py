# SPDX-License-Identifier: MIT
"""What ./run load makes of its options, and of processor times."""

from __future__ import annotations

import os

import pytest
from toolchain.console import Failure
from toolchain.load import Settings
from toolchain.process_times import parse_stat, thread_seconds


def test_defaults_and_options() -> None:
    settings = Settings([])
    assert (settings.trainees, settings.observers, settings.clients) == (8, 24, 32)
    assert not settings.has_proxy
    options = ["--loss=2.5", "--delay=25", "--server-options=--bandwidth=100 --root=held"]
    settings = Settings([*options, "--json", "--trainees=0", "--observers=1"])
    assert settings.has_proxy
    assert settings.json
    assert settings.loss == 2.5
    assert settings.server_options == ["--bandwidth=100", "--root=held"]


@pytest.mark.parametrize(
    ("options", "words"),
    [
        (["--trainees=abc"], "--trainees is between 0 and 500, found 'abc'"),
        (["--trainees=-1"], "--trainees"),
        (["--trainees=²"], "--trainees"),
        (["--observers=501"], "--observers"),
        (["--trainees=0", "--observers=0"], "There are no clients"),
        (["--loss=200"], "--loss is between 0 and 95 %, found '200'"),
        (["--loss=nan"], "--loss"),
        (["--delay=-1"], "--delay"),
        (["--delay=1e9"], "--delay"),
        (["--jitter=10"], "--jitter is at most --delay"),
        (["--seconds=0"], "--seconds"),
        (["--rate="], "--rate"),
        (["--port=70000"], "--port"),
        (["--bvh=/nowhere.bvh"], "There is no motion file /nowhere.bvh"),
        (["--server-options='"], "--server-options cannot be read"),
        (["--nonsense=1"], "has no option --nonsense"),
        (["8"], "'8' is no option"),
    ],
)
def test_bad_options_are_named(options: list[str], words: str) -> None:
    with pytest.raises(Failure) as caught:
        Settings(options)
    assert words in str(caught.value)
    assert caught.value.code == 2


def test_a_thread_may_have_any_name() -> None:
    fields = ["S", *["0"] * 10, "150", "50", *["0"] * 30]
    name, seconds = parse_stat(f"12 (a) (b 3) {' '.join(fields)}\n")
    assert name == "a) (b 3"
    assert seconds == 200 / os.sysconf("SC_CLK_TCK")


def test_our_own_threads() -> None:
    found = thread_seconds(os.getpid())
    assert found[os.getpid()][1] > 0.0
    assert thread_seconds(2**30) == {}
