# SPDX-License-Identifier: MIT
"""The generator's functions, with a small API of our own making."""

import json
import subprocess
import sys
from pathlib import Path

import pytest

BINDINGS = Path(__file__).resolve().parent.parent
sys.path.insert(0, str(BINDINGS))

from generator import classes, defaults, enums, interface, naming
from generator.api import Api, check_supported, enabled_classes
from generator.errors import GeneratorError, UnsupportedType
from generator.output import Output
from generator.type_map import CppType, Kind, TypeMap


def method(name: str, **extra) -> dict:
    """A method of a class as the dump has it."""
    flags = dict.fromkeys(["is_const", "is_static", "is_vararg", "is_virtual"], False)
    return {"name": name, "hash": 7, **flags, **extra}


def engine_class(name: str, inherits: str = "", **extra) -> dict:
    """A class as the dump has it."""
    return {"name": name, "inherits": inherits, "is_refcounted": False, "methods": [], **extra}


def fake_dump() -> dict:
    """An engine with a handful of classes."""
    types = ["NIL", "BOOL", "INT", "STRING", "ARRAY"]
    arguments = [
        {"name": "index", "type": "int", "meta": "int32", "default_value": "-1"},
        {"name": "class", "type": "String", "default_value": '"x"'},
    ]
    thing_methods = [
        method("count", return_value={"type": "int", "meta": "int32"}, is_const=True),
        method("pick", arguments=arguments, return_value={"type": "Thing"}),
        method("other", arguments=[{"name": "other", "type": "Elsewhere"}]),
        method("_made", is_virtual=True),
        method("_mix", arguments=[{"name": "to", "type": "Frame*"}], is_virtual=True),
        method("mix", arguments=[{"name": "to", "type": "Frame*"}]),
    ]
    return {
        "header": {
            "version_major": 4,
            "version_minor": 6,
            "version_patch": 3,
            "version_full_name": "Godot 4.6.3",
        },
        "native_structures": [
            {"name": "Frame", "format": "float left;float right"},
            {"name": "Mixed", "format": "float left;String name"},
        ],
        "builtin_class_sizes": [
            {"build_configuration": "float_32", "sizes": [{"name": "String", "size": 4}]},
            {"build_configuration": "float_64", "sizes": [{"name": "String", "size": 8}]},
        ],
        "global_enums": [
            {"name": "Error", "is_bitfield": False, "values": [{"name": "OK", "value": 0}]},
            {
                "name": "Variant.Type",
                "values": [
                    {"name": f"TYPE_{name}", "value": value} for value, name in enumerate(types)
                ],
            },
        ],
        "utility_functions": [],
        "builtin_classes": [{"name": "int"}, {"name": "String"}],
        "classes": [
            engine_class("Object", methods=[method("is_class")]),
            engine_class("RefCounted", "Object", is_refcounted=True),
            engine_class("Shared", "RefCounted", is_refcounted=True),
            engine_class("Thing", "Object", methods=thing_methods),
            engine_class("Elsewhere", "Object"),
        ],
        "singletons": [{"name": "Thing", "type": "Thing"}],
    }


@pytest.fixture
def api() -> Api:
    return Api(fake_dump(), ["Thing", "Shared", "Frame"])


@pytest.mark.parametrize(
    ("name", "file"),
    [
        ("Node", "node"),
        ("PhysicsServer3D", "physics_server3d"),
        ("PhysicsDirectBodyState3D", "physics_direct_body_state3d"),
        ("AABB", "aabb"),
        ("OS", "os"),
        ("Vector2i", "vector2i"),
        ("PackedFloat32Array", "packed_float32_array"),
        ("XRBodyTracker", "xr_body_tracker"),
    ],
)
def test_files_are_named_as_in_godot_cpp(name, file):
    assert naming.snake_case(name) == file


def test_keywords_are_no_identifiers():
    assert naming.identifier("typeof") == "typeof_"
    assert naming.identifier("count") == "count"


def test_parents_come_first_and_are_implied(api):
    assert list(api.classes) == ["Object", "RefCounted", "Thing", "Shared"]


def test_sizes_are_those_of_64_bit_single_precision(api):
    assert api.sizes == {"String": 8}


def test_an_unknown_class_is_named_with_the_engine():
    with pytest.raises(GeneratorError, match=r'"Nowhere".*Godot 4\.6\.3'):
        Api(fake_dump(), ["Thing", "Nowhere"])


@pytest.mark.parametrize("profile", [{}, {"enabled_classes": "Node"}, {"enabled_classes": [1]}])
def test_a_profile_without_a_list_of_classes_is_refused(profile):
    with pytest.raises(GeneratorError, match="enabled_classes"):
        enabled_classes(profile)


def test_disabled_classes_are_refused():
    with pytest.raises(GeneratorError, match="disabled_classes"):
        enabled_classes({"enabled_classes": ["Node"], "disabled_classes": ["Node3D"]})


def test_old_and_double_precision_engines_are_refused():
    with pytest.raises(GeneratorError, match=r"4\.5"):
        check_supported({"header": {"version_major": 4, "version_minor": 5}})
    with pytest.raises(GeneratorError, match="double"):
        header = {"version_major": 4, "version_minor": 6, "precision": "double"}
        check_supported({"header": header})


@pytest.mark.parametrize(
    ("name", "meta", "spelling"),
    [
        ("int", None, "int64_t"),
        ("int", "uint8", "uint8_t"),
        ("float", "float", "float"),
        ("float", "double", "double"),
        ("Variant", None, "Variant"),
        ("enum::Error", None, "Error"),
        ("enum::Thing.Kind", None, "Thing::Kind"),
        ("bitfield::Thing.Flags", None, "BitField<Thing::Flags>"),
        ("typedarray::Thing", None, "TypedArray<Thing>"),
        ("typedarray::int", None, "TypedArray<int64_t>"),
        ("Thing", None, "Thing *"),
        ("Shared", None, "Ref<Shared>"),
        ("const void*", None, "const void *"),
        ("Frame*", None, "Frame *"),
    ],
)
def test_types(api, name, meta, spelling):
    assert TypeMap(api).find(name, meta).spelling == spelling


@pytest.mark.parametrize("name", ["Elsewhere", "enum::Elsewhere.Kind", "Elsewhere*", "Mixed*"])
def test_what_is_outside_the_profile_is_unsupported(api, name):
    with pytest.raises(UnsupportedType):
        TypeMap(api).find(name)


def test_narrow_arguments_are_widened(api):
    types = TypeMap(api)
    statement, pointer = types.find("int", "int32").encode("p_count")
    assert (statement, pointer) == ("const int64_t p_count_raw = int64_t(p_count);", "&p_count_raw")
    assert types.find("int").encode("p_count") == ("", "&p_count")


@pytest.mark.parametrize(
    ("value", "cpp", "expression"),
    [
        ("null", CppType(Kind.OBJECT, "Node *"), "nullptr"),
        ("null", CppType(Kind.VALUE, "Variant"), "Variant()"),
        ("[]", CppType(Kind.VALUE, "Array"), "Array()"),
        ("Array[RID]([])", CppType(Kind.VALUE, "TypedArray<RID>"), "TypedArray<RID>()"),
        ('&"Master"', CppType(Kind.VALUE, "StringName"), '"Master"'),
        ("-1", CppType(Kind.INTEGER, "int32_t"), "-1"),
        ("0", CppType(Kind.INTEGER, "Node::Mode"), "static_cast<Node::Mode>(0)"),
        ("6", CppType(Kind.INTEGER, "BitField<A::B>"), "static_cast<A::B>(6)"),
        ("Transform3D(1, 0, 0)", CppType(Kind.VALUE, "Transform3D"), "Transform3D()"),
        ("Vector3(0, 1, 0)", CppType(Kind.VALUE, "Vector3"), "Vector3(0, 1, 0)"),
    ],
)
def test_defaults(value, cpp, expression):
    assert defaults.default_expression(value, cpp) == expression


def test_large_enum_values_are_long():
    values = [{"name": "BIG", "value": 2**40}]
    assert f"\tBIG = {2**40}LL," in enums.enum_lines({"name": "A.Size", "values": values})


def test_a_class(api):
    writer = classes.ClassWriter(api, TypeMap(api), "Thing")
    writer.write()
    header = "\n".join(writer.header_lines())
    source = "\n".join(writer.source_lines())
    assert "static Thing *get_singleton();" in header
    assert "int32_t count() const;" in header
    assert 'Thing *pick(int32_t p_index = -1, const String &p_class = "x");' in header
    assert "virtual void _made();" in header
    assert 'add_virtual<Class>("_made", &Class::_made)' in header
    assert "other" not in header
    assert "virtual void _mix(Frame *p_to);" in header
    assert "#include <godot_cpp/classes/frame.hpp>" in header
    assert " mix(" not in header, "pointers are for virtuals alone"
    assert writer.skipped == 2
    assert '{ "count", 7, nullptr }' in source
    assert '"_made", 7' not in source


def test_methods_of_structures_outside_the_profile_are_left_out():
    api = Api(fake_dump(), ["Thing"])
    writer = classes.ClassWriter(api, TypeMap(api), "Thing")
    writer.write()
    assert "_mix" not in "\n".join(writer.header_lines())


def test_a_native_structure():
    text = "\n".join(classes.structure_lines("Frame", "float left;float right"))
    assert "struct Frame {\n\tfloat left = 0;\n\tfloat right = 0;\n};" in text


def test_interface_functions():
    header = """
/**
 * @name first_thing
 */
typedef void (*GDExtensionInterfaceFirstThing)(int p_a);
/**
 * @name second_thing
 * @deprecated Use third_thing.
 */
typedef void (*GDExtensionInterfaceSecondThing)(int p_a);
/**
 * @name third_thing
 */
typedef void *(*GDExtensionsInterfaceThirdThing)(int p_a);
"""
    assert interface.functions(header) == [
        ("first_thing", "GDExtensionInterfaceFirstThing"),
        ("third_thing", "GDExtensionsInterfaceThirdThing"),
    ]
    with pytest.raises(GeneratorError):
        interface.functions("int main();")


def test_output_is_written_where_it_changed(tmp_path):
    (tmp_path / "stale.cpp").write_text("old")
    output = Output()
    output.add("a.cpp", ["int a;"])
    output.write(tmp_path)
    stamp = (tmp_path / "a.cpp").stat().st_mtime_ns
    output.write(tmp_path)
    assert (tmp_path / "a.cpp").stat().st_mtime_ns == stamp
    assert not (tmp_path / "stale.cpp").exists()


def test_command_line_says_what_is_wrong(tmp_path):
    (tmp_path / "api.json").write_text(json.dumps(fake_dump()))
    (tmp_path / "profile.json").write_text('{"enabled_classes": ["Nowhere"]}')
    command = [sys.executable, "-B", "-m", "generator", "--out", str(tmp_path / "out")]
    command += ["--api", str(tmp_path / "api.json"), "--interface", str(tmp_path / "none.h")]
    command += ["--profile", str(tmp_path / "profile.json")]
    done = subprocess.run(
        command, cwd=BINDINGS, capture_output=True, text=True, timeout=60, check=False
    )
    assert done.returncode == 1
    assert '"Nowhere"' in done.stderr
    assert "Traceback" not in done.stderr
