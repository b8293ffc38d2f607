class_name RokokoWriter
extends StreamWriter
## Writes somebody's poses as Rokoko Studio streams them: JSON version 3, see [RokokoReader].

## The person's name.
var name: String = "Dismount"

var _began_usec: int = -1


func set_person(_p_number: int, p_name: String) -> void:
	name = p_name


func write(p_pose: PoseSample) -> Array[PackedByteArray]:
	if _began_usec < 0:
		_began_usec = p_pose.time_usec
	_figure.solve(p_pose)
	var body: Dictionary = {}
	for bone: String in RokokoReader.JOINTS:
		body[bone] = _bone(bone, RokokoReader.JOINTS[bone], p_pose)
	var actor: Dictionary = {
		"name": name,
		"color": [255, 128, 0],
		"meta": {"hasGloves": false, "hasBody": true, "hasFace": false},
		"dimensions": {"totalHeight": _size.height, "hipHeight": _size.length(&"hip_height")},
		"body": body,
	}
	var time_s: float = (p_pose.time_usec - _began_usec) / 1e6
	var scene: Dictionary = {"timestamp": time_s, "actors": [actor], "characters": [], "props": []}
	var message: Dictionary = {"version": "3,0", "fps": 60, "scene": scene}
	return [JSON.stringify(message, "", false, true).to_utf8_buffer()]


func _bone(p_bone: String, p_joint: int, p_pose: PoseSample) -> Dictionary:
	var limb: int = HumanoidAxes.JOINTS.find(p_joint)
	var turn: Quaternion = Quaternion.IDENTITY
	var place: Vector3 = Vector3.ZERO
	if limb >= 0:
		turn = p_pose.orientation(limb)
		place = _figure.bases[limb]
	else:
		var holder: int = Limbs.CHEST
		if p_joint == XRBodyTracker.JOINT_LEFT_TOES:
			holder = Limbs.LEFT_FOOT
		elif p_joint == XRBodyTracker.JOINT_RIGHT_TOES:
			holder = Limbs.RIGHT_FOOT
		turn = p_pose.orientation(holder)
		place = _figure.tails[holder]
		if p_pose.details != null:
			turn = p_pose.details.joints.get(p_joint, turn)
	var rest: Array = RokokoReader.REST[p_bone]
	# Godot's map to Unity's frame is its own inverse.
	var own: Quaternion = Quaternion(turn.x, -turn.y, -turn.z, turn.w)
	own *= Quaternion(rest[1], rest[2], rest[3], rest[0]).normalized()
	return {
		"position": {"x": -place.x, "y": place.y, "z": place.z},
		"rotation": {"x": own.x, "y": own.y, "z": own.z, "w": own.w},
	}
