class_name LevelMutations
extends RefCounted
## Sound and hostile levels with a few bytes or lines changed by chance, the same ones for a seed.

## All that a level from elsewhere may ever contain; kept here by hand, apart from the kit's rows.
const CLASSES: PackedStringArray = [
	"Node3D",
	"Marker3D",
	"StaticBody3D",
	"RigidBody3D",
	"CollisionShape3D",
	"MeshInstance3D",
	"OmniLight3D",
	"SpotLight3D",
	"DirectionalLight3D",
	"WorldEnvironment",
]

var _random: RandomNumberGenerator = RandomNumberGenerator.new()
var _sources: Array[PackedByteArray] = []


func _init(p_seed: int) -> void:
	_random.seed = p_seed
	_sources.append(FileAccess.get_file_as_bytes("res://scenes/world/hall/hall.tscn"))
	for _more: int in 20:
		_sources.append(LevelTexts.level().to_utf8_buffer())
	var hostile: Dictionary[String, Array] = HostileLevels.all()
	for kind: String in hostile:
		var bytes: PackedByteArray = hostile[kind][0]
		if bytes.size() > 1 and bytes.size() < 20000:
			_sources.append(bytes)


## The next level.
func next() -> PackedByteArray:
	var bytes: PackedByteArray = _sources[_random.randi() % _sources.size()].duplicate()
	for _time: int in 1 if _random.randf() < 0.5 else _random.randi_range(2, 4):
		match _random.randi() % 7:
			0:
				bytes[_random.randi() % bytes.size()] = _random.randi() % 256
			1:
				bytes = bytes.slice(0, _random.randi() % bytes.size() + 1)
			2:
				bytes = _exchange_lines(bytes)
			3:
				bytes = _splice(bytes)
			4, 5:
				_change_digit(bytes)
			6:
				var at: int = _random.randi() % bytes.size()
				var end: int = mini(at + _random.randi() % 40, bytes.size())
				bytes = bytes.slice(0, at) + bytes.slice(at, end) + bytes.slice(at)
	return bytes


## What is in a level that may not be; an empty text if there is nothing.
static func find_stranger(p_level: Level) -> String:
	for node: Node in [p_level] + p_level.find_children("*", "", true, false):
		if node.scene_file_path != "" or node.owner != null:
			continue  # Of a scene of the kit.
		var script: Script = node.get_script()
		if script != null and not script.resource_path.begins_with("res://scripts/world/"):
			return "%s has the script %s" % [node.name, script.resource_path]
		if not CLASSES.has(node.get_class()):
			return "%s is a %s" % [node.name, node.get_class()]
		for signal_info: Dictionary in node.get_signal_list():
			for connection: Dictionary in node.get_signal_connection_list(signal_info["name"]):
				var target: Object = (connection["callable"] as Callable).get_object()
				if target is Node and connection["flags"] & CONNECT_PERSIST != 0:
					return "%s is connected" % node.name
	return ""


func _change_digit(r_bytes: PackedByteArray) -> void:
	var at: int = _random.randi() % r_bytes.size()
	while at < r_bytes.size() and (r_bytes[at] < 0x30 or r_bytes[at] > 0x39):
		at += 1
	if at < r_bytes.size():
		r_bytes[at] = 0x30 + _random.randi() % 10


## Puts one of its lines in the place of another.
func _exchange_lines(p_bytes: PackedByteArray) -> PackedByteArray:
	var from: Vector2i = _find_line(p_bytes)
	var to: Vector2i = _find_line(p_bytes)
	return p_bytes.slice(0, to.x) + p_bytes.slice(from.x, from.y) + p_bytes.slice(to.y)


func _find_line(p_bytes: PackedByteArray) -> Vector2i:
	var at: int = _random.randi() % p_bytes.size()
	var begin: int = p_bytes.rfind(10, at) + 1 if at > 0 else 0
	var end: int = p_bytes.find(10, at)
	return Vector2i(mini(begin, at), end if end >= 0 else p_bytes.size())


func _splice(p_bytes: PackedByteArray) -> PackedByteArray:
	var other: PackedByteArray = _sources[_random.randi() % _sources.size()]
	var at: int = _random.randi() % p_bytes.size()
	var from: int = _random.randi() % other.size()
	return p_bytes.slice(0, at) + other.slice(from, from + _random.randi() % 400)
