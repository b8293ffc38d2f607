class_name SceneSection
extends RefCounted
## A section of a text scene as [SceneText] reads it: a tag with its attributes, and the properties
## below it. Nothing in it has acted or been made yet.

## Number of the tag's line in the file, from 1.
var line: int = 0
## What the section is, such as [code]node[/code].
var tag: String = ""
## The tag's attributes by name.
var attributes: Dictionary[String, Variant] = {}
## Names of the properties, in the order of the file.
var names: PackedStringArray = []
## Their values, as [SceneValues] reads them.
var values: Array = []
## Numbers of their lines.
var lines: PackedInt32Array = []


## An attribute that is a text; empty if it is missing or something else.
func text(p_name: String) -> String:
	var value: Variant = attributes.get(p_name, "")
	return value if value is String else ""


## The value of a property, or null.
func value_of(p_name: String) -> Variant:
	var index: int = names.find(p_name)
	return values[index] if index >= 0 else null
