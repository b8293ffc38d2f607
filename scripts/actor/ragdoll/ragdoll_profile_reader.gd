@tool
class_name RagdollProfileReader
extends RefCounted
## Reads a [RagdollProfile] from a JSON file such as
## [code]assets/avatar/shapes/soldier.json[/code].
##
## The file holds a list [code]geoms[/code] of pills and boxes as the thesis's Lua file does
## (section 6.2). Errors name the file and the entry; nothing is half-loaded.

## What was wrong with the file that was read last, or an empty text.
var error: String = ""

var _path: String = ""


## Reads a file; returns null and sets [member error] where it is no profile.
func read(p_path: String) -> RagdollProfile:
	_path = p_path
	error = ""
	var file: FileAccess = FileAccess.open(p_path, FileAccess.READ)
	if file == null:
		return _refuse("cannot be read: %s" % error_string(FileAccess.get_open_error()))
	var json: JSON = JSON.new()
	if json.parse(file.get_as_text()) != OK:
		error = "%s:%d: %s" % [p_path, json.get_error_line(), json.get_error_message()]
		return null
	var data: Variant = json.data
	if data is not Dictionary or (data as Dictionary).get("geoms") is not Array:
		return _refuse("expected an object with a list 'geoms'")
	return _read_geoms((data as Dictionary)["geoms"])


func _read_geoms(p_geoms: Array) -> RagdollProfile:
	var profile: RagdollProfile = RagdollProfile.new()
	for i: int in p_geoms.size():
		if p_geoms[i] is not Dictionary:
			return _refuse("geom %d: expected an object" % (i + 1))
		var limb: RagdollLimb = _read_limb(p_geoms[i], i + 1)
		if limb == null:
			return null
		profile.limbs.append(limb)
	var fault: String = profile.find_fault()
	if fault != "":
		return _refuse(fault)
	return profile


func _read_limb(p_geom: Dictionary, p_number: int) -> RagdollLimb:
	var limb: RagdollLimb = RagdollLimb.new()
	var parent: Variant = p_geom.get("parent_bone")
	if p_geom.get("bone") is not String:
		return _refuse("geom %d: expected a text as 'bone'" % p_number)
	if parent != null and parent is not String:
		return _refuse("geom %d: expected a text or null as 'parent_bone'" % p_number)
	limb.bone = StringName(p_geom["bone"])
	limb.parent_bone = &"" if parent == null else StringName(parent)
	var kind: String = str(p_geom.get("type", ""))
	if kind != "pill" and kind != "box":
		return _refuse("geom %d: expected type 'pill' or 'box', found '%s'" % [p_number, kind])
	limb.type = RagdollLimb.PILL if kind == "pill" else RagdollLimb.BOX
	var wanted: Dictionary[String, int] = {"position": 3, "orientation": 4, "anchor": 3}
	if limb.type == RagdollLimb.BOX:
		wanted["size"] = 3
	for key: String in wanted:
		if not _is_numbers(p_geom.get(key), wanted[key]):
			_refuse("geom %d: expected %d numbers as '%s'" % [p_number, wanted[key], key])
			return null
	for key: String in ["mass_fraction"] + (["radius", "length"] if kind == "pill" else []):
		if p_geom.get(key) is not float:
			_refuse("geom %d: expected a number as '%s'" % [p_number, key])
			return null
	_fill(limb, p_geom)
	LimbAnatomy.fill(limb)
	return limb


static func _fill(p_limb: RagdollLimb, p_geom: Dictionary) -> void:
	p_limb.position = _vector(p_geom["position"])
	p_limb.anchor = _vector(p_geom["anchor"])
	var turn: Array = p_geom["orientation"]
	p_limb.orientation = Quaternion(turn[0], turn[1], turn[2], turn[3])
	p_limb.mass_fraction = p_geom["mass_fraction"]
	if p_limb.type == RagdollLimb.BOX:
		p_limb.size = _vector(p_geom["size"])
	else:
		p_limb.radius = p_geom["radius"]
		p_limb.length = p_geom["length"]


static func _vector(p_numbers: Array) -> Vector3:
	return Vector3(p_numbers[0], p_numbers[1], p_numbers[2])


static func _is_numbers(p_value: Variant, p_count: int) -> bool:
	if p_value is not Array or (p_value as Array).size() != p_count:
		return false
	return (p_value as Array).all(func(item: Variant) -> bool: return item is float)


func _refuse(p_why: String) -> Variant:
	error = "%s: %s" % [_path, p_why]
	return null
