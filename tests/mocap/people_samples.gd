extends RefCounted
## Clips of a person whose joints may have any names, rest pose and heading, for the tests.

## Joints: name here, parent here, place in the T-pose (file units: cm; facing +Z). Those of the
## left side are mirrored. An empty parent is the root.
const JOINTS: Array[Array] = [
	["Hips", "", Vector3(0, 100, 0)],
	["Spine", "Hips", Vector3(0, 110, 0)],
	["Chest", "Spine", Vector3(0, 125, 0)],
	["Neck", "Chest", Vector3(0, 150, 0)],
	["Head", "Neck", Vector3(0, 158, 0)],
	["HeadEnd", "Head", Vector3(0, 180, 0)],
	["LeftShoulder", "Chest", Vector3(4, 145, 0)],
	["LeftUpperArm", "LeftShoulder", Vector3(18, 145, 0)],
	["LeftLowerArm", "LeftUpperArm", Vector3(46, 145, 0)],
	["LeftHand", "LeftLowerArm", Vector3(72, 145, 0)],
	["LeftHandEnd", "LeftHand", Vector3(90, 145, 0)],
	["LeftUpperLeg", "Hips", Vector3(10, 95, 0)],
	["LeftLowerLeg", "LeftUpperLeg", Vector3(10, 50, 0)],
	["LeftFoot", "LeftLowerLeg", Vector3(10, 8, 0)],
	["LeftToes", "LeftFoot", Vector3(10, 2, 14)],
	["LeftToesEnd", "LeftToes", Vector3(10, 2, 20)],
]
const _ARM: Vector3 = Vector3(18, 145, 0)


## What a person's clip is made of.
class Person:
	## The file's names by those here; an empty name leaves the joint out.
	var names: Dictionary[String, String] = {}
	## How far the arms hang at rest: 0 T-pose, 45 A-pose, 90 I-pose, degrees.
	var arms_deg: float = 0.0
	## Which way the person faces at rest: 0 is +Z, 90 is +X, degrees.
	var heading_deg: float = 0.0
	## For each frame, local rotations by name here, in axes of a person who faces +Z.
	var frames: Array[Dictionary] = [{}]


## The clip of a person.
static func make(p_person: Person) -> BvhClip:
	var joints: Array[BvhJoint] = []
	var found: Dictionary[String, int] = {}
	var keys: PackedStringArray = []
	for row: Array in _rows():
		var key: String = row[0]
		var file_name: String = p_person.names.get(key, key)
		found[key] = found.get(row[1], -1)
		if file_name == "":
			continue
		var joint: BvhJoint = BvhJoint.new()
		joint.is_end_site = key.ends_with("End")
		joint.name = "" if joint.is_end_site else file_name
		joint.parent = found[key]
		var place: Vector3 = _place(p_person, row)
		var above: Vector3 = Vector3.ZERO
		if joint.parent >= 0:
			above = _place(p_person, _row(keys[joint.parent]))
		joint.offset = place - above
		if not joint.is_end_site:
			joint.channels = _channels(joint.parent < 0)
		found[key] = joints.size()
		keys.append(key)
		joints.append(joint)
	var clip: BvhClip = BvhClip.new()
	clip.source_name = "person.bvh"
	clip.set_data(joints, _values(p_person, joints, keys), 1.0 / 60.0)
	return clip


## The local rotations that bring a person with hanging arms into the T-pose.
static func t_pose(p_arms_deg: float) -> Dictionary:
	return {
		"LeftUpperArm": Quaternion(Vector3.BACK, deg_to_rad(p_arms_deg)),
		"RightUpperArm": Quaternion(Vector3.BACK, -deg_to_rad(p_arms_deg)),
	}


static func _rows() -> Array[Array]:
	var rows: Array[Array] = []
	for row: Array in JOINTS:
		rows.append(row)
	for row: Array in JOINTS:
		if (row[0] as String).begins_with("Left"):
			var place: Vector3 = row[2]
			var parent: String = (row[1] as String).replace("Left", "Right")
			place.x = -place.x
			rows.append([(row[0] as String).replace("Left", "Right"), parent, place])
	return rows


static func _row(p_key: String) -> Array:
	for row: Array in _rows():
		if row[0] == p_key:
			return row
	return []


static func _place(p_person: Person, p_row: Array) -> Vector3:
	var place: Vector3 = p_row[2]
	var key: String = p_row[0]
	if key.contains("Arm") or key.contains("Hand"):
		var side: float = 1.0 if key.begins_with("Left") else -1.0
		var shoulder: Vector3 = _ARM * Vector3(side, 1.0, 1.0)
		var hang: Quaternion = Quaternion(Vector3.BACK, -side * deg_to_rad(p_person.arms_deg))
		place = shoulder + hang * (place - shoulder)
	return place.rotated(Vector3.UP, deg_to_rad(p_person.heading_deg))


static func _channels(p_is_root: bool) -> PackedInt32Array:
	var channels: PackedInt32Array = []
	if p_is_root:
		channels.append_array([0, 1, 2])
	channels.append_array(
		[BvhJoint.Channel.Z_ROTATION, BvhJoint.Channel.X_ROTATION, BvhJoint.Channel.Y_ROTATION]
	)
	return channels


static func _values(
	p_person: Person, p_joints: Array[BvhJoint], p_keys: PackedStringArray
) -> PackedFloat64Array:
	var values: PackedFloat64Array = []
	var heading: Quaternion = Quaternion(Vector3.UP, deg_to_rad(p_person.heading_deg))
	for frame: Dictionary in p_person.frames:
		for i: int in p_joints.size():
			if p_joints[i].is_end_site:
				continue
			if i == 0:
				var root: Vector3 = frame.get("root", p_joints[0].offset)
				values.append_array([root.x, root.y, root.z])
			var turn: Quaternion = frame.get(p_keys[i], Quaternion.IDENTITY)
			turn = heading * turn * heading.inverse()
			var angles: Vector3 = turn.get_euler(EULER_ORDER_ZXY)
			for angle: float in [angles.z, angles.x, angles.y]:
				values.append(rad_to_deg(angle))
	return values
