@tool
class_name KitEntry
extends RefCounted
## What the level kit needs to know of a [KitBlock]: what a level that comes from elsewhere may set
## of it, how many of it a level may have, and how the editor's dock offers it. Each class of blocks
## says so in [code]static func kit_entry()[/code], and is part of the kit by that alone.

## What received levels may have of it: a row of [LevelKit].
var row: KitClass = null
## What the dock offers.
var items: Array[KitItem] = []


## The entry of a class of blocks, of which a level may have so many at most. What a hint in the
## inspector limits has the same limits in a level; what is without one is named here.
static func of_block(
	p_class: GDScript, p_most: int, p_named: Dictionary[String, PropertyRule] = {}
) -> KitEntry:
	var rules: Dictionary[String, PropertyRule] = p_named.duplicate()
	for property: Dictionary in p_class.get_script_property_list():
		var is_export: bool = property["usage"] & PROPERTY_USAGE_EDITOR != 0
		var rule: PropertyRule = PropertyRule.from_hint(property) if is_export else null
		if rule != null and not rules.has(property["name"]):
			rules[property["name"]] = rule
	var entry: KitEntry = KitEntry.new()
	entry.row = KitClass.scripted(
		p_class.get_global_name(),
		"StaticBody3D",
		p_class.resource_path,
		rules,
		KitClass.body_rules()
	)
	entry.row.with_bodies(1).at_most(p_most)
	return entry


## The entries of all classes of blocks that there are, by folder and then by name.
static func all() -> Array[KitEntry]:
	var found: Array[KitEntry] = []
	for path: String in ClassPaths.extending(&"KitBlock"):
		var entry: KitEntry = (load(path) as GDScript).call(&"kit_entry")
		if entry != null:
			found.append(entry)
	return found


## Has the dock offer it under a title, with further words by which it is found, values of its
## properties, and the height of its origin above what it stands on, m.
func offered(
	p_title: String, p_words: String, p_values: Dictionary = {}, p_lift: float = 0.0
) -> KitEntry:
	items.append(KitItem.new(p_title, p_words, row.path, KitItem.Place.STATIC, p_values, p_lift))
	return self
