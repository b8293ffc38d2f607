# SPDX-License-Identifier: MIT
"""Each package of `./run package` in an empty project that is made on the spot, and used there."""

from __future__ import annotations

import dataclasses
import json
import os
import re
import shutil
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from toolchain import arrows, package, suit
from toolchain.console import Failure
from toolchain.paths import CLIPS, ROOT

from .conftest import Process, World
from .suits import engine, needs_emulator

PROBES = ROOT / "tests" / "system" / "packages"
# An import takes 10 s of a processor: minutes where many others want it.
LIMIT_S = 600.0
WAIT_S = 300.0

# What docs/packages/ragdoll_motor.md asks for.
PHYSICS = """
[physics]

3d/physics_engine="Jolt Physics"
jolt_physics_3d/simulation/velocity_steps=40
"""
GODOT_PHYSICS = """
[physics]

3d/physics_engine="GodotPhysics3D"
"""
FEW_STEPS = """
[physics]

3d/physics_engine="Jolt Physics"
"""


class Project:
    """A Godot project with packages in it and nothing else; the engine has a home of its own."""

    def __init__(self, folder: Path, names: list[str]) -> None:
        self.folder = folder / "project"
        self.folder.mkdir()
        self.configure()
        package.write(names, self.folder / "addons")

    def configure(self, settings: str = PHYSICS) -> None:
        """Writes the project's settings."""
        text = f'config_version=5\n\n[application]\n\nconfig/name="Test"\n{settings}'
        (self.folder / "project.godot").write_text(text, encoding="utf-8")

    def godot(
        self, world: World, name: str, *arguments: str, before: tuple[str, ...] = ()
    ) -> Process:
        """Starts the engine in the project."""
        program = os.environ["DISMOUNT_GODOT"]
        command = [*before, program, "--headless", "--path", str(self.folder), *arguments]
        return world.start(name, command, reports=False)

    def probe(self, world: World, script: str, *arguments: str, **more: Any) -> Process:
        """Starts one of our scripts in the project."""
        shutil.copyfile(PROBES / script, self.folder / script)
        count = len(world.processes)
        return self.godot(world, f"{count}_{script}", "-s", f"res://{script}", *arguments, **more)

    def import_first(self, world: World) -> None:
        """The first import: the editor has never seen the project."""
        assert not (self.folder / ".godot").exists()
        run = self.godot(world, "import", "--import")
        assert run.await_exit(LIMIT_S) == 0, run.log()
        assert no_errors(run), run.log()
        assert (self.folder / ".godot" / "extension_list.cfg").exists()


def no_errors(run: Process) -> bool:
    """Whether the engine has found nothing wrong."""
    return re.search(r"ERROR|Parse Error|leaked", run.log()) is None


@pytest.fixture(scope="module")
def project_with(tmp_path_factory: pytest.TempPathFactory) -> Callable[..., Project]:
    """Gives a project with packages, which is made and imported for the first who wants it."""
    made: dict[tuple[str, ...], Project] = {}

    def give(*names: str) -> Project:
        if names not in made:
            world = World(tmp_path_factory.mktemp("_".join(names)))
            project = Project(world.folder, list(names))
            try:
                project.import_first(world)
            finally:
                world.close()
            made[names] = project
        made[names].configure()
        return made[names]

    return give


ALONE = [(name,) for name in package.PACKAGES]


@pytest.mark.parametrize("names", [*ALONE, tuple(package.PACKAGES)])
def test_everything_in_it_loads(
    world: World, project_with: Callable[..., Project], names: tuple[str, ...]
) -> None:
    project = project_with(*names)
    run = project.probe(world, "load_all.gd")
    assert run.await_exit(LIMIT_S) == 0, run.log()
    assert no_errors(run), run.log()
    there = [*project.folder.rglob("addons/**/*.gd"), *project.folder.rglob("addons/**/*.tscn")]
    assert f"loaded {len(there)}" in run.log()
    for name in names:
        addon = project.folder / "addons" / name
        assert (addon / "README.md").stat().st_size > 1000
        assert (addon / "LICENSE").exists()
        example = f"res://addons/{name}/example/{name}.tscn"
        run = project.godot(world, name, "--fixed-fps", "60", "--quit-after", "30", example)
        assert run.await_exit(LIMIT_S) == 0, run.log()
        assert no_errors(run), run.log()


@pytest.mark.parametrize("by", ["clip", "animation"])
def test_a_character_follows(world: World, project_with: Callable[..., Project], by: str) -> None:
    project = project_with("ragdoll_motor")
    run = project.probe(world, "use_ragdoll_motor.gd", "--fixed-fps", "60", "--", f"--by={by}")
    assert run.await_exit(LIMIT_S) == 0, run.log()
    assert no_errors(run), run.log()
    assert "WARNING" not in run.log(), run.log()
    found = json.loads(next(line for line in run.log().splitlines() if line.startswith("{")))
    assert found["bodies"] == 16
    assert found["count"] > 4.5 * 60 * 16
    assert found["mean_deg"] < 3.0
    assert found["turned_deg"] > 30.0


@pytest.mark.parametrize(
    ("settings", "said"),
    [
        (GODOT_PHYSICS, "with which limbs do not follow"),
        (FEW_STEPS, "velocity steps limbs follow badly"),
    ],
)
def test_unfit_physics_are_told(
    world: World, project_with: Callable[..., Project], settings: str, said: str
) -> None:
    project = project_with("ragdoll_motor")
    project.configure(settings)
    run = project.probe(world, "use_ragdoll_motor.gd", "--fixed-fps", "60", "--", "--by=clip")
    assert run.await_exit(LIMIT_S) == 0, run.log()
    assert said in run.log(), run.log()


def test_a_package_that_needs_more_is_refused() -> None:
    files = arrows.read_files(ROOT)
    narrow = dataclasses.replace(package.PACKAGES["ragdoll_motor"], roots=("ActorView",))
    with pytest.raises(Failure, match="would need the library wire, as scripts/actor/view"):
        package.collect("ragdoll_motor", narrow, files)


def test_packages_of_one_call_share(tmp_path: Path) -> None:
    both = package.write(["ragdoll_motor", "xbus"], tmp_path)
    names = [
        path.relative_to(folder) for folder in both for path in folder.rglob("scripts/**/*.gd")
    ]
    assert len(names) == len(set(names))
    scene = (both[1] / "example" / "xbus.tscn").read_text(encoding="utf-8")
    assert "res://addons/ragdoll_motor/example/soldier.glb" in scene
    assert "res://addons/xbus/example/xbus.gd" in scene


def test_pages_lead_nowhere_else(tmp_path: Path) -> None:
    for folder in package.write(package.PACKAGES, tmp_path):
        for page in folder.rglob("*.md"):
            for link in re.findall(r"\]\(([^)\s]+)\)", page.read_text(encoding="utf-8")):
                assert link.startswith("http") or (page.parent / link).exists(), f"{page}: {link}"


@needs_emulator
def test_a_suit_moves_a_body_tracker(world: World, project_with: Callable[..., Project]) -> None:
    project = project_with("xbus")
    pipe = world.folder / "commands"
    os.mkfifo(pipe)
    commands = os.open(pipe, os.O_RDWR)
    own = [f"--bvh={CLIPS / '01_01.bvh'}", "--hold", f"--commands={pipe}"]
    emulator = (str(suit.PROGRAM), *suit.complete(engine(), own), "--")
    try:
        run = project.probe(world, "use_xbus.gd", before=emulator)
        run.await_text("calibrated", WAIT_S)
        os.write(commands, b"go\n")
        run.await_text("all joints have moved", WAIT_S)
        assert run.await_exit(WAIT_S) == 0, run.log()
        assert "ERROR" not in run.log(), run.log()
    finally:
        os.close(commands)


def test_two_peers_talk(world: World, project_with: Callable[..., Project]) -> None:
    project = project_with("threaded_peer")
    port = f"--port={world.port}"
    server = project.probe(world, "use_threaded_peer.gd", "--", "--server", port)
    server.await_text("listening", WAIT_S)
    client = project.probe(world, "use_threaded_peer.gd", "--", port)
    assert client.await_exit(WAIT_S) == 0, client.log()
    assert "spawned a MeshInstance3D" in client.log(), client.log()
    assert "answered 1" in client.log(), client.log()
    assert no_errors(client), client.log()
    assert "spawned a MeshInstance3D" in server.log(), server.log()
    assert no_errors(server), server.log()
