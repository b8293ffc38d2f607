@tool
class_name ClassPaths
extends RefCounted
## Finds the scripts of all classes that extend one, so that a class is part of something by what it
## extends, and nobody has to list it.


## Paths of the scripts whose classes extend a class of a script, or a class that does, sorted.
static func extending(p_class: StringName) -> PackedStringArray:
	var bases: Dictionary[StringName, StringName] = {}
	var classes: Array[Dictionary] = ProjectSettings.get_global_class_list()
	for each: Dictionary in classes:
		bases[each["class"]] = each["base"]
	var paths: PackedStringArray = []
	for each: Dictionary in classes:
		var base: StringName = each["base"]
		while base != p_class and bases.has(base):
			base = bases[base]
		if base == p_class:
			paths.append(each["path"])
	paths.sort()
	return paths
