# SPDX-License-Identifier: MIT
"""The pieces of ./run and ./test that decide something."""

from __future__ import annotations

import errno
import socket
from pathlib import Path
from types import ModuleType

import pytest
from toolchain import (
    cli,
    demo,
    gdscript_tests,
    godot,
    godot_cpp,
    help_texts,
    latency,
    load,
    options,
    paths,
    prefix,
    processes,
    project,
    testing,
)
from toolchain.console import Failure
from toolchain.demo import Settings
from toolchain.nearest import options_in


@pytest.mark.parametrize(
    ("text", "numbers", "templates"),
    [
        ("4.6.3.stable.debian4.6.3+ds-2", (4, 6, 3), "4.6.3.stable"),
        ("4.6.stable.official.89cea1439", (4, 6), "4.6.stable"),
        ("4.7.beta2.official", (4, 7), "4.7.beta2"),
        ("Written by Jim Meyering.", (), ""),
        ("", (), ""),
    ],
)
def test_versions(text: str, numbers: tuple[int, ...], templates: str) -> None:
    assert godot.parse_version(text) == (numbers, templates)


def test_an_old_godot_is_not_taken(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    old = tmp_path / "godot"
    old.write_text("#!/bin/sh\necho 4.3.stable.official\n")
    old.chmod(0o755)
    monkeypatch.setenv("GODOT", str(old))
    with pytest.raises(Failure, match=r"4\.3\.stable"):
        godot.installed()
    monkeypatch.delenv("GODOT")
    monkeypatch.setenv("PATH", str(tmp_path))
    assert godot.installed() is None


def test_a_new_godot_is_taken(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    new = tmp_path / "godot"
    new.write_text("#!/bin/sh\necho 4.7.1.stable.official\n")
    new.chmod(0o755)
    monkeypatch.setenv("GODOT", str(new))
    found = godot.installed()
    assert found is not None
    assert found.version == "4.7.1.stable"


def test_the_mirror_comes_from_the_machine(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("DISMOUNT_DEBIAN_MIRROR", "file:///mirror")
    assert prefix.mirrors() == ["file:///mirror"]


def test_no_mirror_is_a_sentence(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("DISMOUNT_USER_CACHE", str(tmp_path))
    monkeypatch.setenv("DISMOUNT_DEBIAN_MIRROR", f"file://{tmp_path}/nothing")
    with pytest.raises(Failure, match="DISMOUNT_DEBIAN_MIRROR"):
        prefix.Prefix().ensure()
    assert not prefix.Prefix().folder.exists()


def test_options_are_normalised(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("DISMOUNT_CWD", "/somewhere")
    given = ["--port", "7778", "--bvh=walk.bvh", "--", "--name", "Ada", "--json"]
    wanted = ["--port=7778", "--bvh=/somewhere/walk.bvh", "--name=Ada", "--json"]
    assert cli.normalise(given) == wanted


def test_roles_come_from_the_document_of_options() -> None:
    roles = options.roles()
    assert {"server", "observer", "trainee", "instructor", "replay"} <= set(roles)
    assert all(roles.values())


def test_a_document_that_differs_is_a_fault_with_its_remedy(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    document = tmp_path / "options.md"
    monkeypatch.setattr(options, "DOCUMENT", document)
    monkeypatch.setattr(options, "make", lambda _godot: "# Options\n\n## Roles\n")
    monkeypatch.setattr(options, "ROOT", tmp_path)
    monkeypatch.setattr(help_texts, "FOLDER", tmp_path / "help")
    monkeypatch.setattr(
        help_texts, "make", lambda _godot: {tmp_path / "help" / "server.txt": "./run server\n"}
    )
    engine = godot.Godot(tmp_path, "", "")
    assert options.roles() == {}
    options.write(engine)
    assert options.fault(engine) == ""
    document.write_text("# Options\n", encoding="utf-8")
    assert "./run options-doc" in options.fault(engine)
    assert options.fault(engine).startswith("options.md differ")
    (tmp_path / "help" / "gone.txt").write_text("./run gone\n", encoding="utf-8")
    assert "help/gone.txt" in options.fault(engine)
    options.write(engine)
    assert options.fault(engine) == ""


def test_what_the_engine_has_not_freed_is_found() -> None:
    output = """7 passed, 0 failed
WARNING: ObjectDB instances leaked at exit (run with --verbose for details).
   at: cleanup (core/object/object.cpp:2663)
ERROR: 23 resources still in use at exit (run with --verbose for details).
ERROR: Pages in use exist at exit in PagedAllocator: N7Variant5Pools12BucketMediumE
"""
    assert len(gdscript_tests.find_leaks(output)) == 3
    assert gdscript_tests.find_leaks("ok   test_what_is_left_at_exit\n7 passed, 0 failed") == []
    named = gdscript_tests.find_leaks(output + "Leaked instance: Mutex:12 - Reference count: 1\n")
    assert "Mutex:12" in named[0]
    # What the engine itself does not untangle.
    script = "Resource still in use: res://scripts/core/log.gd (GDScript)\n"
    assert gdscript_tests.find_leaks(output + script) == [
        "Pages in use exist at exit in PagedAllocator: N7Variant5Pools12BucketMediumE"
    ]


def test_what_a_runner_prints_is_read() -> None:
    output = """ok   core/test_a.gd  test_one  (3 ms)
a line of the next
FAIL core/test_a.gd  test_two  (1200 ms)
     expected 1, got 0
     and one more
ok   core/test_b.gd  test_three  (7 ms)
2 passed, 1 failed
ERROR: 2 resources still in use at exit (run with --verbose for details).
"""
    result = gdscript_tests.read_output(output)
    assert result.passed == {"core/test_a.gd test_one", "core/test_b.gd test_three"}
    assert list(result.failed) == ["core/test_a.gd test_two"]
    said = result.failed["core/test_a.gd test_two"]
    assert said.splitlines()[0] == "a line of the next"
    assert said.endswith("expected 1, got 0\n     and one more")
    assert len(result.faults) == 1
    times = gdscript_tests.read_times(output)
    assert times == pytest.approx({"core/test_a.gd": 1.203, "core/test_b.gd": 0.007})


def test_a_port_in_use_is_a_sentence() -> None:
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as occupant:
        occupant.bind(("0.0.0.0", 0))
        with pytest.raises(Failure, match="in use"):
            processes.require_port(occupant.getsockname()[1])


def test_a_full_disk_is_a_sentence(tmp_path: Path) -> None:
    with pytest.raises(Failure, match="too full"):
        paths.need_space(tmp_path, 10**9, "this test")
    full = OSError(errno.ENOSPC, "No space left on device", "somewhere")
    assert "disk is full" in str(paths.explain(full))


@pytest.mark.parametrize(
    "argument", ["--port=0", "--port=x", "--seconds=x", "--seconds=0", "--bvh=no", "--king=1", "x"]
)
def test_wrong_options_of_the_main_job(argument: str) -> None:
    with pytest.raises(Failure) as caught:
        Settings([argument])
    assert caught.value.code == 2


def test_a_stamp_holds_for_the_same_inputs_only(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(project, "BUILD", tmp_path)
    monkeypatch.setattr(project, "ROOT", tmp_path)
    (tmp_path / "assets").mkdir()
    (tmp_path / "assets" / "a").write_text("1")
    first = project.fingerprint(["assets"], "engine 1")
    assert first == project.fingerprint(["assets"], "engine 1")
    assert first != project.fingerprint(["assets"], "engine 2")
    (tmp_path / "assets" / "a").write_text("2")
    second = project.fingerprint(["assets"], "engine 1")
    assert first != second
    stamp = project.Stamp("test")
    assert not stamp.holds(first)
    stamp.set(first)
    assert stamp.holds(first)
    assert not stamp.holds(second)


def test_a_step_says_why_it_is_done_again(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(project, "BUILD", tmp_path)
    stamp = project.Stamp("test")
    assert stamp.why("hash 4.6") == ""
    stamp.set("hash 4.6")
    assert stamp.why("other 4.6") == ": files have changed"
    assert stamp.why("other 4.7") == ": the engine is 4.7 now"


@pytest.mark.parametrize(("module", "name"), [(demo, "demo"), (latency, "latency"), (load, "load")])
def test_help_names_the_options_that_there_are(module: ModuleType, name: str) -> None:
    for option in options_in(module.HELP):
        if option in ("--json", "--no-goals", "--bandwidth", "--root"):
            continue
        with pytest.raises(Failure) as caught:
            module.Settings([f"{option}=\x00"] if option != "--server-options" else [f"{option}='"])
        assert "has no option" not in str(caught.value), f"{name} {option}"
    with pytest.raises(Failure, match="has no option --king"):
        module.Settings(["--king=1"])


def test_a_folder_that_is_no_godot_cpp_is_refused(tmp_path: Path) -> None:
    with pytest.raises(Failure, match="no checkout of godot-cpp") as caught:
        testing.main([f"--godot-cpp={tmp_path}"])
    assert caught.value.code == 2
    (tmp_path / "binding_generator.py").touch()
    assert godot_cpp.checkout(tmp_path) == tmp_path.resolve()
    assert {"RagdollMotor", "SuitHub", "TransportPump"} <= set(godot_cpp.documented_classes())
