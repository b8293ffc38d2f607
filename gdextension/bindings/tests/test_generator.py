# SPDX-License-Identifier: MIT
"""Tests the generator on a small made-up engine."""

import subprocess
import sys
from pathlib import Path

import pytest

BINDINGS = Path(__file__).resolve().parents[1]
sys.path.insert(0, str(BINDINGS))

from generator import embed_documentation, interface
from generator.__main__ import build
from generator.api import MATH_TYPES, Api, check_supported, enabled_classes, load_json
from generator.cpp_types import CppType, TypeMap, default_expression
from generator.engine_classes import _EngineClass
from generator.enums import enum_lines
from generator.errors import GeneratorError, UnsupportedType
from generator.naming import identifier, snake_case
from generator.output import Output

HEADER = """
/**
 * @name mem_alloc
 * @deprecated in Godot 9.
 */
typedef void *(*GDExtensionInterfaceMemAlloc)(size_t p_bytes);

/**
 * @name print_error
 */
typedef void (*GDExtensionInterfacePrintError)(const char *p_text);

/**
 * @name editor_help
 */
typedef void (*GDExtensionsInterfaceEditorHelp)(const char *p_text);
"""


def method(name: str, **extra) -> dict:
    flags = {"is_const": False, "is_static": False, "is_virtual": False, "is_vararg": False}
    return {"name": name, "hash": 7, **flags, **extra}


def engine_class(name: str, parent: str | None = None, **extra) -> dict:
    entry = {"name": name, "is_refcounted": False, "api_type": "core", **extra}
    return {**entry, "inherits": parent} if parent else entry


def builtin(name: str, **extra) -> dict:
    return {"name": name, "has_destructor": False, "constructors": [], **extra}


def fake_dump() -> dict:
    turn = method(
        "turn",
        is_const=True,
        return_value={"type": "int", "meta": "uint16"},
        arguments=[
            {"name": "axis", "type": "enum::Vector3.Axis"},
            {"name": "default", "type": "float", "default_value": "1.5"},
        ],
    )
    secret = method("secret", arguments=[{"name": "x", "type": "Hidden"}])
    tick = method("_tick", is_virtual=True, arguments=[{"name": "delta", "type": "float"}])
    find = method("find", return_value={"type": "RefCounted"})
    builtins = ["int", "String", *MATH_TYPES]
    types = ["NIL", "BOOL", "FLOAT", *(name.upper() for name in builtins), "MAX"]
    return {
        "header": {
            "version_major": 4,
            "version_minor": 6,
            "version_full_name": "Fake Engine v4.6",
            "precision": "single",
        },
        "global_enums": [
            {
                "name": "Variant.Type",
                "values": [{"name": f"TYPE_{name}", "value": i} for i, name in enumerate(types)],
            },
            {"name": "Variant.Operator", "values": [{"name": "OP_EQUAL", "value": 0}]},
            {"name": "Huge", "values": [{"name": "HUGE_BIT", "value": 2**40}]},
        ],
        "utility_functions": [],
        "singletons": [{"name": "Server", "type": "Server"}],
        "builtin_class_sizes": [
            {"build_configuration": "float_64", "sizes": [{"name": "String", "size": 8}]}
        ],
        "builtin_classes": [builtin(name) for name in builtins],
        "classes": [
            engine_class("Object"),
            engine_class("RefCounted", "Object", is_refcounted=True),
            engine_class("Node", "Object", methods=[turn, secret, tick, find]),
            engine_class("Server", "Node"),
            engine_class("Hidden", "Object"),
        ],
    }


@pytest.fixture
def api() -> Api:
    return Api(fake_dump(), ["Server"])


@pytest.mark.parametrize(
    ("name", "file"),
    [
        ("PhysicsServer3D", "physics_server3d"),
        ("PhysicsDirectBodyState3D", "physics_direct_body_state3d"),
        ("OS", "os"),
        ("RID", "rid"),
        ("AABB", "aabb"),
        ("Vector2i", "vector2i"),
        ("PackedFloat32Array", "packed_float32_array"),
        ("XRServer", "xr_server"),
    ],
)
def test_file_names_are_those_of_godot_cpp(name: str, file: str) -> None:
    assert snake_case(name) == file


def test_keywords_get_an_underscore() -> None:
    assert identifier("new") == "new_"
    assert identifier("typeof") == "typeof_"
    assert identifier("news") == "news"


def test_parents_are_implied_and_come_first(api: Api) -> None:
    assert list(api.classes) == ["Object", "RefCounted", "Node", "Server"]


def test_unknown_class_is_named_with_the_engine() -> None:
    with pytest.raises(GeneratorError, match=r'"Nod".*Fake Engine v4\.6 has no such class'):
        Api(fake_dump(), ["Node", "Nod"])


@pytest.mark.parametrize("profile", [{}, {"enabled_classes": "Node"}, {"enabled_classes": [1]}])
def test_profile_must_list_classes(profile: dict) -> None:
    with pytest.raises(GeneratorError, match="enabled_classes"):
        enabled_classes(profile)


def test_disabled_classes_are_refused() -> None:
    with pytest.raises(GeneratorError, match="disabled_classes"):
        enabled_classes({"enabled_classes": ["Node"], "disabled_classes": ["OS"]})


def test_old_and_double_precision_engines_are_refused() -> None:
    old = fake_dump()
    old["header"]["version_minor"] = 3
    with pytest.raises(GeneratorError, match=r"Godot 4\.3"):
        check_supported(old)
    double = fake_dump()
    double["header"]["precision"] = "double"
    with pytest.raises(GeneratorError, match="double-precision"):
        check_supported(double)


@pytest.mark.parametrize(
    ("name", "meta", "spelling"),
    [
        ("int", None, "int64_t"),
        ("int", "uint8", "uint8_t"),
        ("float", None, "double"),
        ("float", "float", "float"),
        ("String", None, "String"),
        ("Node", None, "Node *"),
        ("RefCounted", None, "Ref<RefCounted>"),
        ("enum::Node.Mode", None, "Node::Mode"),
        ("bitfield::Node.Flags", None, "BitField<Node::Flags>"),
        ("typedarray::Node", None, "TypedArray<Node>"),
        ("typedarray::int", None, "TypedArray<int64_t>"),
        ("typedarray::24/17:Node", None, "Array"),
    ],
)
def test_types(api: Api, name: str, meta: str | None, spelling: str) -> None:
    assert TypeMap(api).find(name, meta).spelling == spelling


@pytest.mark.parametrize("name", ["Hidden", "enum::Hidden.Mode", "const void*"])
def test_types_out_of_reach(api: Api, name: str) -> None:
    with pytest.raises(UnsupportedType):
        TypeMap(api).find(name)


@pytest.mark.parametrize(
    ("value", "cpp", "expression"),
    [
        ("null", CppType("Node *"), "nullptr"),
        ("null", CppType("Variant", by_reference=True), "Variant()"),
        ('&"Master"', CppType("StringName", by_reference=True), '"Master"'),
        ('""', CppType("String", by_reference=True), '""'),
        ("[]", CppType("Array", by_reference=True), "Array()"),
        ("Array[RID]([])", CppType("TypedArray<RID>", by_reference=True), "TypedArray<RID>()"),
        ("0", CppType("Node::Mode", is_enum=True), "static_cast<Node::Mode>(0)"),
        ("6", CppType("BitField<Node::F>", is_enum=True), "static_cast<Node::F>(6)"),
        ("Transform3D(1, 0, 0)", CppType("Transform3D", by_reference=True), "Transform3D()"),
        ("Vector3(0, 1, 0)", CppType("Vector3", by_reference=True), "Vector3(0, 1, 0)"),
        ("true", CppType("bool"), "true"),
    ],
)
def test_defaults(value: str, cpp: CppType, expression: str) -> None:
    assert default_expression(value, cpp) == expression


def test_members_of_a_class(api: Api) -> None:
    node = _EngineClass(api, "Node")
    node.read()
    header = "\n".join(node.header())
    assert "uint16_t turn(Vector3::Axis p_axis, double p_default = 1.5) const;" in header
    assert "virtual void _tick(double p_delta);" in header
    assert "Ref<RefCounted> find();" in header
    assert "class RefCounted;" in header
    assert "secret" not in header
    assert node.skipped == ["Node.secret: Hidden"]
    source = "\n".join(node.source())
    assert 'internal::method_bind("Node", "turn", 7)' in source
    assert "internal::ptrcall<uint16_t>(method, _owner, p_axis, p_default)" in source


def test_singleton(api: Api) -> None:
    server = _EngineClass(api, "Server")
    server.read()
    assert "\tstatic Server *get_singleton();" in server.header()
    assert "class Server : public Node {" in server.header()


def test_enums_are_as_wide_as_needed() -> None:
    huge = {"name": "Node.Huge", "values": [{"name": "BIT", "value": 2**40}]}
    assert enum_lines(huge) == ["enum Huge : int64_t {", "\tBIT = 1099511627776LL,", "};"]


def test_interface_leaves_out_what_is_deprecated() -> None:
    assert interface.functions(HEADER) == [
        ("print_error", "GDExtensionInterfacePrintError"),
        ("editor_help", "GDExtensionsInterfaceEditorHelp"),
    ]
    with pytest.raises(GeneratorError, match="no functions"):
        interface.functions("int x;")


def test_whole_build_lists_what_the_engine_must_have() -> None:
    output, skipped = build(fake_dump(), {"enabled_classes": ["Server"]}, HEADER)
    expected = output.files["src/expected_api.cpp"]
    assert '{ "Node", "turn", 7 },' in expected
    assert "_tick" not in expected, "virtual methods have no hash to look up"
    assert "Fake Engine v4.6" in expected
    assert skipped == ["Node.secret: Hidden"]
    assert "include/godot_cpp/classes/hidden.hpp" not in output.files


def test_output_writes_changes_only_and_removes_stale_files(tmp_path: Path) -> None:
    stale = tmp_path / "src" / "stale.cpp"
    stale.parent.mkdir()
    stale.write_text("", encoding="utf-8")
    output = Output()
    output.add("src/kept.cpp", ["int x;"])
    output.write(tmp_path)
    kept = tmp_path / "src" / "kept.cpp"
    assert not stale.exists()
    assert "do not edit" in kept.read_text(encoding="utf-8")
    before = kept.stat().st_mtime_ns
    output.write(tmp_path)
    assert kept.stat().st_mtime_ns == before


def test_unreadable_input_is_named(tmp_path: Path) -> None:
    with pytest.raises(GeneratorError, match=r"missing\.json"):
        load_json(tmp_path / "missing.json")
    broken = tmp_path / "broken.json"
    broken.write_text("[1", encoding="utf-8")
    with pytest.raises(GeneratorError, match="no JSON object"):
        load_json(broken)


def test_command_fails_with_a_plain_message(tmp_path: Path) -> None:
    missing = tmp_path / "missing"
    names = ("--api", "--interface", "--profile", "--output")
    options = [part for name in names for part in (name, str(missing))]
    result = subprocess.run(
        [sys.executable, "-m", "generator", *options],
        cwd=BINDINGS,
        capture_output=True,
        text=True,
        timeout=60,
        check=False,
    )
    assert result.returncode == 1
    assert result.stderr.startswith("generator: ")
    assert "Traceback" not in result.stderr


def test_documentation_survives_as_a_literal(tmp_path: Path) -> None:
    page = tmp_path / "Page.xml"
    page.write_text('<class name="A">\\ ??/ ü</class>\n', encoding="utf-8")
    text = embed_documentation.source([page])
    assert '"<class name=\\"A\\">\\\\ \\?\\?/ ü</class>\\n"' in text
    page.write_text("<class>", encoding="utf-8")
    with pytest.raises(GeneratorError, match=r"Page\.xml is no readable XML"):
        embed_documentation.source([page])
