class_name LevelReader
extends SceneReader
## Builds a [Level] from a text scene that may come from anybody, without the engine's loader.
##
## ResourceLoader runs the static initialisers of every script in a scene before anything can be
## looked at. Here [SceneText] reads by a grammar without a word for a script, an object, a signal
## or a callable, and only what has a row in [LevelKit] is made, with values in its ranges. Nothing
## is in the tree until the caller puts it there. May be used in a thread.

## Deepest that nodes may lie in each other.
const DEEPEST: int = 16
## Longest name of a node, characters.
const MAX_NAME: int = 64

const _NODE_ATTRIBUTES: PackedStringArray = [
	"name", "type", "parent", "instance", "index", "unique_id", "groups", "node_paths"
]
const _SCALE_ERROR: float = 1e-3
const _STRANGE_RESOURCE: String = "it holds a %s, which the level kit does not know"

static var _early_checks: Array[Array] = _make_early_checks()

var _file: String = ""
var _line: int = 0
# Whole paths of the files beside it, by name.
var _folder: Dictionary[String, String] = {}
# The level's node of each path, and where it stands in the level.
var _nodes: Dictionary[String, Node] = {}
var _places: Dictionary[String, Transform3D] = {}
var _rows: Dictionary[Node, KitClass] = {}
var _root: Node = null
var _resources: SceneResources = null
var _counts: Dictionary[KitClass, int] = {}
var _bodies: int = 0
# Paths of nodes can be followed only when all are there: node, property, rule, path, line.
var _links: Array[Array] = []


## The level of a text scene, not in the tree; null if it is refused. [param p_folder] has the whole
## paths of the files beside it, by name.
func build(
	p_bytes: PackedByteArray, p_file: String, p_folder: Dictionary[String, String] = {}
) -> Level:
	_file = p_file
	_folder = p_folder
	_resources = SceneResources.new(_refuse, _count)
	var text: SceneText = SceneText.new()
	if most_faults == 1:
		text.tag_check = _check_tag
		text.early_checks = _early_checks
	if not text.read(p_bytes):
		_line = text.fault_line
		_refuse(text.fault)
		return null
	for index: int in text.sections.size():
		progress = float(index) / text.sections.size()
		_line = text.sections[index].line
		_take_section(text.sections[index], index)
		if _is_over():
			break
	for link: Array in _links:
		_line = link[4]
		_link(link[0], link[1], link[2], link[3])
	_line = 0
	if _root == null:
		_refuse("it has no node")
	if refusal != "" and _root != null:
		_root.free()
		_root = null
	progress = 1.0
	return _root as Level


## A stranger is named before anybody looks at what it brings along.
func _check_tag(p_section: SceneSection) -> String:
	var type: String = p_section.text("type")
	if p_section.tag == "sub_resource" and not LevelKit.knows(type):
		return _STRANGE_RESOURCE % ByteReader.clean(type.left(60))
	if p_section.tag == "ext_resource" and not LevelKit.allows_file(type, p_section.text("path")):
		return SceneResources.describe_strange(p_section)
	return ""


static func _make_early_checks() -> Array[Array]:
	var known: String = "|".join(LevelKit.bases())
	var texts: Dictionary[String, String] = {
		"^\\[(?!(?:gd_scene|ext_resource|sub_resource|node)[ \\]])([a-z_]{1,40})":
		"it has a [%s]; levels have none",
		'^\\[sub_resource type="(?!(?:%s)")([^"\\n]{0,60})' % known: _STRANGE_RESOURCE,
		'^\\[node name="[^"\\n]*" type="(?!(?:%s)")([^"\\n]{0,60})' % known:
		"it has a node of class %s, which the level kit does not know",
		"^[A-Za-z_][A-Za-z0-9_/]* ?= ?(Object|Resource|Callable|Signal|RID|Dictionary|\\{)":
		"'%s' is no value that a level may hold",
	}
	var checks: Array[Array] = []
	for expression: String in texts:
		checks.append([RegEx.create_from_string("(?m)" + expression), texts[expression]])
	return checks


func _take_section(p_section: SceneSection, p_index: int) -> void:
	match p_section.tag:
		"gd_scene":
			if p_index > 0:
				_refuse("it begins twice")
			elif p_section.attributes.get("format") != SceneText.FORMAT:
				var found: Variant = p_section.attributes.get("format")
				_refuse("it has format %s; this program reads %d" % [found, SceneText.FORMAT])
		"ext_resource":
			_resources.add_external(p_section)
		"sub_resource":
			_resources.add(p_section)
		"node":
			_add_node(p_section)


func _add_node(p_section: SceneSection) -> void:
	var row: KitClass = _find_row(p_section)
	if row == null or not _count(row):
		return
	var place: String = _find_place(p_section)
	if place == "":
		return
	var node: Node = _make(row)
	if node == null:
		_refuse("'%s' cannot be made" % row.key)
		return
	if p_section.attributes.has("type") and p_section.text("type") != node.get_class():
		_refuse("it takes a %s for a %s" % [node.get_class(), p_section.text("type").left(40)])
		node.free()
		return
	node.name = p_section.text("name")
	if _root == null:
		_root = node
	else:
		_nodes[_parent_of(p_section)].add_child(node)
	_nodes[place] = node
	_rows[node] = row
	if p_section.attributes.has("groups"):
		_add_groups(node, p_section.attributes["groups"])
	_set_properties(node, row, p_section)
	_note_place(place, _parent_of(p_section), node, row)


## The row of what a node is; null if it is refused.
func _find_row(p_section: SceneSection) -> KitClass:
	for key: String in p_section.attributes:
		if not _NODE_ATTRIBUTES.has(key):
			_refuse("a node has '%s'" % key)
			return null
	if p_section.attributes.has("instance"):
		return _find_scene(p_section)
	if not p_section.attributes.has("type"):
		_refuse("it changes the node '%s' of an instance" % p_section.text("name").left(40))
		return null
	var type: String = p_section.text("type")
	var script: Variant = p_section.value_of("script")
	var path: String = ""
	if script != null:
		path = _resources.path_of(script, "Script")
		if path == "":
			_refuse("its script is none of the level kit's")
			return null
	var row: KitClass = LevelKit.find(type, path)
	if row == null or row.kind != KitClass.Kind.NODE:
		var what: String = "%s with the script %s" % [type, path] if path != "" else type
		_refuse("it has a node of class %s, which the level kit does not know" % what.left(120))
		return null
	var is_root: bool = _root == null
	if is_root != (row.key == "Level"):
		_refuse("its root has to be a Level, and nothing else can be one")
		return null
	return row


func _find_scene(p_section: SceneSection) -> KitClass:
	var path: String = _resources.path_of(p_section.attributes["instance"], "PackedScene")
	var row: KitClass = LevelKit.find_scene(path) if path != "" else null
	if row == null:
		_refuse("it holds an instance of what is no scene of the level kit")
		return null
	if _root == null:
		_refuse("its root has to be a Level, and nothing else can be one")
		return null
	return row


## The path at which a node comes to stand; empty if it is refused.
func _find_place(p_section: SceneSection) -> String:
	var name: String = p_section.text("name")
	if not _is_name(name):
		_refuse("a node is called '%s'" % ByteReader.clean(name.left(40)))
		return ""
	if _root == null:
		if p_section.attributes.has("parent"):
			_refuse("the first node has a parent")
			return ""
		return "."
	var parent: String = p_section.text("parent")
	if not _nodes.has(parent):
		_refuse("the parent '%s' is missing" % ByteReader.clean(parent.left(80)))
		return ""
	if not _rows[_nodes[parent]].takes_children:
		_refuse("a node lies below '%s', an instance of the level kit" % parent.left(80))
		return ""
	if parent.get_slice_count("/") >= DEEPEST:
		_refuse("nodes lie more than %d deep" % DEEPEST)
		return ""
	var place: String = name if parent == "." else "%s/%s" % [parent, name]
	if _nodes.has(place):
		_refuse("there are two nodes '%s'" % place.left(80))
		return ""
	return place


func _parent_of(p_section: SceneSection) -> String:
	return p_section.text("parent")


func _make(p_row: KitClass) -> Node:
	if p_row.kind == KitClass.Kind.SCENE:
		return _resources.scene(p_row.path).instantiate()
	if p_row.path != "":
		return (load(p_row.path) as GDScript).new()
	return ClassDB.instantiate(p_row.base)


func _add_groups(p_node: Node, p_groups: Variant) -> void:
	if not p_groups is PackedStringArray:
		_refuse("its groups are broken")
		return
	for group: String in p_groups:
		if not LevelKit.GROUPS.has(group) or not p_node is RigidBody3D:
			_refuse("'%s' is in the group '%s'" % [p_node.name, ByteReader.clean(group.left(40))])
			return
		p_node.add_to_group(group, true)


func _set_properties(p_node: Node, p_row: KitClass, p_section: SceneSection) -> void:
	for index: int in p_section.names.size():
		var name: String = p_section.names[index]
		_line = p_section.lines[index]
		if name == "script" and _is_own_script(p_row, p_section.values[index]):
			continue
		var rule: PropertyRule = p_row.rules.get(name)
		if rule == null:
			_refuse("'%s' of a %s may not be set" % [name, p_row.key])
			continue
		var value: Variant = p_section.values[index]
		if rule.kind == PropertyRule.Kind.NODE or rule.kind == PropertyRule.Kind.PATH:
			_links.append([p_node, name, rule, value, _line])
		elif rule.kind == PropertyRule.Kind.FILE:
			_set_file(p_node, name, rule, value)
		else:
			_resources.set_value(p_node, name, rule, value)
	_line = p_section.line


## Whether a script is the one that the node has anyway.
func _is_own_script(p_row: KitClass, p_value: Variant) -> bool:
	if p_row.kind == KitClass.Kind.NODE:
		return true
	var path: String = _resources.path_of(p_value, "Script")
	return path != "" and path == p_row.root_script


func _set_file(p_node: Node, p_name: String, p_rule: PropertyRule, p_value: Variant) -> void:
	# The editor saves whole paths of the project: only the name counts.
	var file: String = p_value if p_value is String else ""
	file = file.get_file() if file.begins_with("res://") else file
	if not _folder.has(file) or file.get_extension() != p_rule.classes[0]:
		var parts: Array = [p_name, ByteReader.clean(file.left(80)), p_rule.classes[0]]
		_refuse("'%s' names '%s', which is no *.%s of the level's folder" % parts)
		return
	p_node.set(p_name, _folder[file])


## Notes where a node stands in the level; bodies that are scaled or too far away are refused, as
## the physics cannot take them.
func _note_place(p_place: String, p_parent: String, p_node: Node, p_row: KitClass) -> void:
	var own: Transform3D = (
		(p_node as Node3D).transform if p_node is Node3D else Transform3D.IDENTITY
	)
	var above: Transform3D = _places.get(p_parent, Transform3D.IDENTITY)
	var whole: Transform3D = above * own if p_place != "." else own
	_places[p_place] = whole
	if not whole.origin.length() <= PropertyRule.FARTHEST:
		_refuse("'%s' stands too far from the level's origin" % p_place.left(80))
	var is_true: bool = whole.basis.is_finite()
	var size: Vector3 = whole.basis.get_scale() if is_true else Vector3.ZERO
	if p_row.bodies > 0 and not (size - Vector3.ONE).abs().length() < _SCALE_ERROR:
		_refuse("'%s' is a body that is scaled or mirrored" % p_place.left(80))


## Follows a path to another node of the level.
func _link(p_node: Node, p_name: String, p_rule: PropertyRule, p_value: Variant) -> void:
	var path: NodePath = p_value if p_value is NodePath else NodePath()
	var target: Node = null
	var is_inside: bool = not path.is_empty() and not path.is_absolute()
	if is_inside and path.get_subname_count() == 0 and path.get_name_count() <= 2 * DEEPEST:
		target = _follow(p_node, path)
	if target == null:
		_refuse("'%s' is no path to a node of the level" % p_name)
		return
	var wanted: PackedStringArray = p_rule.classes
	if not wanted.is_empty() and not wanted.has(_key_of(target)):
		_refuse("'%s' has to name a %s" % [p_name, " or ".join(wanted)])
		return
	if p_rule.kind == PropertyRule.Kind.NODE:
		p_node.set(p_name, target)
	else:
		p_node.set(p_name, path)


## The node at a path; null where the path leaves the level, or ends at a node of an instance of the
## kit that is not for others.
func _follow(p_from: Node, p_path: NodePath) -> Node:
	var at: Node = p_from
	for index: int in p_path.get_name_count():
		var name: StringName = p_path.get_name(index)
		if name == &"..":
			at = at.get_parent() if at != _root else null
		elif name != &".":
			at = at.get_node_or_null(NodePath(name))
		if at == null:
			return null
	return at if _key_of(at) != "" else null


## The key of a node of the level, or of one in an instance of the kit that others may name; else an
## empty text.
func _key_of(p_node: Node) -> String:
	var instance: Node = p_node
	while not _rows.has(instance):
		instance = instance.get_parent()
	var row: KitClass = _rows[instance]
	return row.key if instance == p_node else row.inner.get(str(instance.get_path_to(p_node)), "")


func _count(p_row: KitClass) -> bool:
	var count: int = _counts.get(p_row, 0) + 1
	_counts[p_row] = count
	_bodies += p_row.bodies
	if count > p_row.most:
		_refuse("it has more than %d of %s" % [p_row.most, p_row.key])
		return false
	if _bodies > LevelKit.MAX_BODIES:
		_refuse("it has more than %d bodies" % LevelKit.MAX_BODIES)
		return false
	return true


func _refuse(p_why: String) -> void:
	var where: String = "%s, line %d: " % [_file, _line] if _line > 0 else "%s: " % _file
	if refusal == "":
		refusal = where + p_why
	if faults.size() < most_faults:
		faults.append(where + p_why)


func _is_over() -> bool:
	return refusal != "" and faults.size() >= most_faults


static func _is_name(p_name: String) -> bool:
	if p_name == "" or p_name.length() > MAX_NAME or p_name != ByteReader.clean(p_name):
		return false
	return p_name == p_name.validate_node_name() and p_name.strip_edges() == p_name
