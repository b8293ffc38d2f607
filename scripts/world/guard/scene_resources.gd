class_name SceneResources
extends RefCounted
## The resources of a received level: those that it holds, made from rows of [LevelKit], and the
## program's own files that it names.

# func(why: String) -> void
var _refuse: Callable = Callable()
# func(row: KitClass) -> bool
var _count: Callable = Callable()
# Declared files of the program by id: type and path.
var _externals: Dictionary[String, PackedStringArray] = {}
var _loaded: Dictionary[String, Resource] = {}
var _made: Dictionary[String, Resource] = {}
var _keys: Dictionary[String, String] = {}


## Says why something is refused by a callable, and lets another count what is made.
func _init(p_refuse: Callable, p_count: Callable) -> void:
	_refuse = p_refuse
	_count = p_count


## Takes the declaration of a file of the program.
func add_external(p_section: SceneSection) -> void:
	var path: String = p_section.text("path")
	var type: String = p_section.text("type")
	for key: String in p_section.attributes:
		if not key in ["type", "path", "uid", "id"]:
			_refuse.call("a file has '%s'" % key)
			return
	if not LevelKit.allows_file(type, path):
		_refuse.call(describe_strange(p_section))
		return
	var id: String = p_section.text("id")
	if id == "" or _externals.has(id):
		_refuse.call("two files have the id '%s'" % id.left(40))
		return
	_externals[id] = PackedStringArray([type, path])


## What is said of a file that no level may name.
static func describe_strange(p_section: SceneSection) -> String:
	var type: String = ByteReader.clean(p_section.text("type").left(40))
	var path: String = ByteReader.clean(p_section.text("path").left(120))
	return "it uses the %s '%s', which is none of the level kit's" % [type, path]


## Makes a resource that the level holds.
func add(p_section: SceneSection) -> void:
	var type: String = p_section.text("type")
	var id: String = p_section.text("id")
	var script: String = ""
	if p_section.names.has("script"):
		script = path_of(p_section.value_of("script"), "Script")
		if script == "":
			_refuse.call("its script is none of the level kit's")
			return
	var row: KitClass = LevelKit.find(type, script)
	if row == null or row.kind != KitClass.Kind.RESOURCE:
		_refuse.call("it holds a %s, which the level kit does not know" % type.left(80))
		return
	if id == "" or _made.has(id) or p_section.attributes.size() != 2:
		_refuse.call("a resource without an id of its own")
		return
	if not _count.call(row):
		return
	var made: Resource = ClassDB.instantiate(type) if script == "" else load(script).new()
	_made[id] = made
	_keys[id] = row.key
	for index: int in p_section.names.size():
		var name: String = p_section.names[index]
		if name == "script":
			continue
		var rule: PropertyRule = row.rules.get(name)
		if rule == null:
			_refuse.call("'%s' of a %s may not be set" % [name, row.key])
			return
		set_value(made, name, rule, p_section.values[index])


## The path of a declared file, if the value names one of this type; else an empty text.
func path_of(p_value: Variant, p_type: String) -> String:
	var reference: SceneReference = p_value as SceneReference
	if reference == null or reference.kind != SceneReference.Kind.EXTERNAL:
		return ""
	var file: PackedStringArray = _externals.get(reference.id, PackedStringArray(["", ""]))
	return file[1] if file[0] == p_type else ""


## A scene of the kit.
func scene(p_path: String) -> PackedScene:
	return _load(p_path) as PackedScene


## Sets a property to what a value says, if its rule takes it.
func set_value(p_object: Object, p_name: String, p_rule: PropertyRule, p_value: Variant) -> void:
	match p_rule.kind:
		PropertyRule.Kind.IGNORED:
			return
		PropertyRule.Kind.RESOURCE:
			if p_value == null:
				return
			var found: Resource = _find(p_name, p_rule, p_value as SceneReference)
			if found != null:
				p_object.set(p_name, found)
			return
		PropertyRule.Kind.RESOURCES:
			_set_list(p_object, p_name, p_rule, p_value as SceneReference)
			return
	var faults: PackedStringArray = []
	var value: Variant = p_rule.take(p_value, faults)
	if faults.is_empty():
		p_object.set(p_name, value)
	else:
		_refuse.call("'%s' %s" % [p_name, faults[0]])


func _set_list(
	p_object: Object, p_name: String, p_rule: PropertyRule, p_list: SceneReference
) -> void:
	if p_list == null or p_list.items.size() > p_rule.most:
		_refuse.call("'%s' has to be a list of at most %.0f" % [p_name, p_rule.most])
		return
	# A copy of what is there has the type that the property wants.
	var list: Array = (p_object.get(p_name) as Array).duplicate()
	list.clear()
	for item: SceneReference in p_list.items:
		var found: Resource = _find(p_name, p_rule, item)
		if found == null:
			return
		list.append(found)
	p_object.set(p_name, list)


func _find(p_name: String, p_rule: PropertyRule, p_reference: SceneReference) -> Resource:
	var key: String = ""
	var found: Resource = null
	if p_reference != null and p_reference.kind == SceneReference.Kind.SUB:
		key = _keys.get(p_reference.id, "")
		found = _made.get(p_reference.id)
	elif p_reference != null and _externals.has(p_reference.id):
		key = _externals[p_reference.id][0]
		if p_rule.classes.has(key):
			found = _load(_externals[p_reference.id][1])
			found = found if found != null and found.is_class(key) else null
	if found == null or not p_rule.classes.has(key):
		_refuse.call("'%s' has to be a %s" % [p_name, ", ".join(p_rule.classes)])
		return null
	return found


func _load(p_path: String) -> Resource:
	if not _loaded.has(p_path):
		_loaded[p_path] = load(p_path) if ResourceLoader.exists(p_path) else null
	return _loaded[p_path]
