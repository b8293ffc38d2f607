# SPDX-License-Identifier: MIT
"""Help, as a machine gives it that has nothing yet: no Python, no compiler, no build."""

from __future__ import annotations

import shutil
import subprocess

import pytest
from toolchain import cli, demo, help_texts, nearest, options
from toolchain.paths import CLIPS, ROOT

# Debian calls these essential: they are on every machine.
TOOLS = ("bash", "env", "cat", "head", "dirname", "readlink")
COMMANDS = ("latency", "load", "bench", "bvh", "xbus-decode", "suit-emulator")
COMMANDS += ("motion-sender", "motion-set", "platform-watch")


@pytest.fixture(scope="module")
def bare(tmp_path_factory: pytest.TempPathFactory) -> dict[str, str]:
    """The environment of a machine that has a shell."""
    folder = tmp_path_factory.mktemp("bin")
    for tool in TOOLS:
        (folder / tool).symlink_to(str(shutil.which(tool)))
    return {"PATH": str(folder), "HOME": "/nonexistent"}


def ask(environment: dict[str, str], *arguments: str) -> subprocess.CompletedProcess[str]:
    return subprocess.run(
        [str(ROOT / "run"), *arguments],
        cwd="/",
        env=environment,
        stdin=subprocess.DEVNULL,
        capture_output=True,
        text=True,
        timeout=120,
        check=False,
    )


def test_help_of_everything_needs_a_shell_only(bare: dict[str, str]) -> None:
    done = ask(bare, "--help")
    assert done.returncode == 0, done.stderr
    for name in [*COMMANDS, *(role for role in options.roles() if role != "load")]:
        assert f"./run {name}" in done.stdout
        for call in ((name, "--help"), (name, "--name=x", "-h"), ("help", name)):
            one = ask(bare, *call)
            assert one.returncode == 0, one.stderr
            assert one.stdout.startswith(f"./run {name}"), one.stdout
            assert one.stderr == ""


def test_help_of_a_benchmark(bare: dict[str, str]) -> None:
    listed = ask(bare, "bench")
    assert listed.returncode == 0
    names = [line.split()[0] for line in listed.stdout.splitlines()]
    assert set(names) == set(cli.benchmarks())
    assert all(len(line.split()) > 3 for line in listed.stdout.splitlines())
    for name in names:
        about = ask(bare, "bench", name, "--help")
        assert about.returncode == 0
        assert about.stdout.strip()
    assert "--scene=NAME" in ask(bare, "bench", "contacts", "--help").stdout


def test_the_version(bare: dict[str, str]) -> None:
    assert ask(bare, "--version").stdout.startswith("Dismount 0.")


@pytest.mark.parametrize(
    ("wrong", "complaint"),
    [
        ("obsever", "There is no command 'obsever': did you mean observer?"),
        ("sever", "There is no command 'sever': did you mean server?"),
        ("hlep", "There is no command 'hlep': did you mean help?"),
        ("xbus_decode", "There is no command 'xbus_decode': did you mean xbus-decode?"),
        ("fortune", "There is no command 'fortune': see ./run --help."),
        ("--hlep", "./run has no option --hlep: did you mean --help?"),
        ("--prot=7000", "./run has no option --prot: did you mean --port?"),
        ("--colour", "./run has no option --colour: see ./run --help."),
    ],
)
def test_a_mistyped_command_names_the_nearest(
    bare: dict[str, str], wrong: str, complaint: str
) -> None:
    done = ask(bare, wrong)
    assert done.returncode == 2
    assert done.stderr == complaint + "\n"
    assert done.stdout == ""


def test_known_options_are_not_refused_by_the_shell(bare: dict[str, str]) -> None:
    for option in nearest.options_in(demo.HELP):
        assert "has no option" not in ask(bare, f"{option}=1").stderr


def test_help_behind_two_hyphens_is_the_command_s(bare: dict[str, str]) -> None:
    done = ask(bare, "suit-emulator", "--", "./run", "--help")
    assert "umockdev" not in done.stdout


def test_what_a_choice_can_be() -> None:
    server = help_texts.read("server")
    levels = [one.parent.name for one in ROOT.glob("scenes/world/*/*.tscn")]
    for known in ("soft", "inertial", *(name for name in levels if name == "hall")):
        assert known in server
    assert "adaptive_low_delay" in help_texts.read("observer")
    assert all(motion.name in help_texts.MAIN_FILE.read_text() for motion in CLIPS.glob("*.bvh"))


@pytest.mark.parametrize(
    ("command", "wrong", "right"),
    [
        ("suit-emulator", "--sensor=3", "--sensors"),
        ("latency", "--second=3", "--seconds"),
        ("load", "--trainee=3", "--trainees"),
        ("package", "--json", ""),
    ],
)
def test_a_mistyped_option_names_the_nearest(command: str, wrong: str, right: str) -> None:
    with pytest.raises(cli.Failure, match=f"did you mean {right}" if right else "--help") as caught:
        cli.main([command, wrong])
    assert caught.value.code == 2


def test_names_of_options_are_read_from_help() -> None:
    text = "  --port=NUMBER   a port; see --host and a-b--c\n  --no-goals  none"
    assert nearest.options_in(text) == ["--port", "--host", "--no-goals"]
    nearest.check_options("./run x", ["--port=1", "word", "--"], text)
