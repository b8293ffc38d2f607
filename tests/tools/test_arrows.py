# SPDX-License-Identifier: MIT
"""The gate of the folders' order, with made-up trees that break each of its rules."""

from __future__ import annotations

import pytest
from toolchain import arrows
from toolchain.arrows import Order, OrderError, check, read_tokens

ORDER = Order.parse(
    """
    # A comment.
    features: core < net world < server client < app
    net: messages transport < session < .
    only net/transport: core
    """
)
SOUND = {
    "scripts/core/log.gd": "class_name Log\nextends RefCounted\n",
    "scripts/net/messages/greeting.gd": "class_name Greeting\n",
    "scripts/net/transport/wire.gd": "class_name Wire\nvar log: Log\n",
    "scripts/net/session/door.gd": "class_name Door\nvar wire: Wire\nvar greeting: Greeting\n",
    "scripts/net/link.gd": "class_name Link\nvar door: Door\n",
    "scripts/world/hall.gd": "class_name Hall\n",
    "scripts/server/server.gd": "class_name Server\nvar link: Link\n",
    "scripts/client/client.gd": 'var hall: String = "res://scenes/world/hall.tscn"\n',
    "scripts/app/main.gd": 'const _CLIENT: String = "res://scenes/client/client.tscn"\n',
    "scenes/world/hall.tscn": '[ext_resource path="res://scripts/world/hall.gd"]\n',
    "scenes/client/client.tscn": '[ext_resource path="res://scripts/client/client.gd"]\n',
}


def faults(**changed: str) -> list[str]:
    """What is wrong with the sound tree and a file more or another: folder__name = text."""
    extra = {
        f"{name.replace('__', '/')}.{'tscn' if name.startswith('scenes') else 'gd'}": text
        for name, text in changed.items()
    }
    return check({**SOUND, **extra}, ORDER)


def test_a_sound_tree_has_no_faults() -> None:
    assert faults() == []


@pytest.mark.parametrize(
    ("file", "text", "fault"),
    [
        ("scripts__core__a", "var x: Server", "core comes before server"),
        ("scripts__client__a", "func f() -> void:\n\tServer.new()", "client comes beside server"),
        ("scripts__world__a", "extends Link", "world comes beside net"),
        ("scripts__net__messages__a", "var x: Door", "messages comes before session"),
        ("scripts__net__messages__a", "var x: Wire", "messages comes beside transport"),
        ("scripts__net__session__a", "var x: Link", "session comes before ."),
        ("scripts__net__transport__a", "var x: Greeting", "net/transport may use core only"),
        ("scripts__core__a", 'preload("res://scripts/app/main.gd")', "core comes before app"),
        ("scripts__world__a", 'load("res://scenes/client/client.tscn")', "world comes before"),
        ("scenes__world__a", '[x path="res://scripts/app/main.gd"]', "world comes before app"),
        ("scenes__client__a", '[x path="res://scripts/server/server.gd"]', "client comes beside"),
        ("scripts__client__a", 'load("res://scripts/client/gone.gd")', "which is not there"),
        ("scripts__sound__a", "class_name Tone", "sound: it is not in the line 'features:'"),
        ("scripts__net__chat__a", "class_name Chat", "'chat' is not in a line 'net:'"),
        ("scripts__world__props__a", "class_name Crate", "'props' is not in a line 'world:'"),
    ],
)
def test_each_rule_can_be_broken(file: str, text: str, fault: str) -> None:
    found = faults(**{file: text})
    assert any(fault in line for line in found), found


def test_a_ring_of_folders_is_named() -> None:
    tree = {
        "scripts/net/a/one.gd": "class_name One\nvar two: Two",
        "scripts/net/b/two.gd": "class_name Two\nvar three: Three",
        "scripts/net/c/three.gd": "class_name Three\nvar one: One",
        "scripts/net/d/four.gd": "class_name Four\nvar one: One",
    }
    found = check(tree, Order.parse("features: net"))
    assert "folders in a ring: net/a, net/b, net/c" in found
    tree["scripts/net/c/three.gd"] = "class_name Three"
    assert not any("ring" in line for line in check(tree, Order.parse("features: net")))


def test_the_shortest_circle_of_scripts_is_named() -> None:
    tree = {
        "scripts/net/one.gd": "class_name One\nvar two: Two",
        "scripts/net/two.gd": "class_name Two\nvar three: Three",
        "scripts/net/three.gd": '@abstract class_name Three\nvar a: One\nload("res://scripts/net/a.gd")',
        "scripts/net/a.gd": "@tool class_name A\nvar three: Three",
        "scripts/net/user.gd": "class_name User\nvar three: Three",
    }
    found = [line for line in check(tree, Order.parse("features: net")) if "circle" in line]
    path = "scripts/net/a.gd -> scripts/net/three.gd -> scripts/net/a.gd"
    assert found == [f"scripts in a circle: {path}"]
    tree["scripts/net/three.gd"] = "class_name Three  # See One and A."
    assert check(tree, Order.parse("features: net")) == []


def test_a_scene_and_the_script_that_makes_it_are_no_circle() -> None:
    tree = {
        "scripts/net/one.gd": 'class_name One\nload("res://scenes/net/one.tscn")',
        "scenes/net/one.tscn": '[x path="res://scripts/net/one.gd"]',
    }
    assert check(tree, Order.parse("features: net")) == []


def test_comments_and_texts_are_no_use_but_paths_are() -> None:
    text = """
# Server does it, see res://scripts/app/main.gd.
## See [Server] and [member Client.x].
var a: String = "Server # and more"
var b: StringName = &"Server"
var c: String = 'it\\'s Server'
var d: String = \"\"\"
Server
\"\"\"
const E: String = "res://scenes/world/hall.tscn"
var f: Link = null  # Server
"""
    names, paths = read_tokens(text)
    assert "Server" not in names and "Client" not in names
    assert "Link" in names
    assert paths == {"scenes/world/hall.tscn"}


@pytest.mark.parametrize(
    ("text", "fault"),
    [
        ("features core", "expected"),
        ("features:", "expected"),
        ("features: a < < b", "between two arrows"),
        ("features: a < b a", "'a' stands there twice"),
        ("features: a\nfeatures: b", "has an order already"),
        ("features: a\nb: x", "'b' has an order, but is no feature"),
        ("net: a", "there is no line 'features: ...'"),
    ],
)
def test_a_wrong_order_is_told(text: str, fault: str) -> None:
    with pytest.raises(OrderError, match=fault.replace("(", r"\(")):
        Order.parse(text)


def test_the_repository_is_found() -> None:
    files = arrows.read_files(arrows.ROOT)
    assert "scripts/core/log.gd" in files
    assert "scenes/app/main.tscn" in files
    uses = {(use.user, use.used) for use in arrows.find_uses(files)}
    assert ("scripts/app/main.gd", "scenes/client/client.tscn") in uses
