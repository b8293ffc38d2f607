extends RefCounted
## Writes motion files as many programs do, from the motion of our own clips, for the tests.

const Schemes: GDScript = preload("foreign_schemes.gd")

## Joints of a person, and the joint that each hangs on.
const PARENTS: Dictionary[String, String] = {
	"Hips": "",
	"Spine": "Hips",
	"Chest": "Spine",
	"Neck": "Chest",
	"Head": "Neck",
	"HeadEnd": "Head",
	"Shoulder": "Chest",
	"UpperArm": "Shoulder",
	"LowerArm": "UpperArm",
	"Hand": "LowerArm",
	"HandEnd": "Hand",
	"UpperLeg": "Hips",
	"LowerLeg": "UpperLeg",
	"Foot": "LowerLeg",
	"Toes": "Foot",
	"ToesEnd": "Toes",
}
## Parts of either side: of the arms, of the legs.
const SIDED: PackedStringArray = [
	"Shoulder",
	"UpperArm",
	"LowerArm",
	"Hand",
	"HandEnd",
	"UpperLeg",
	"LowerLeg",
	"Foot",
	"Toes",
	"ToesEnd"
]
const _ARM_PARTS: int = 5
## Our clips: unit, and the names of the joints above; what is missing is named as here.
const CLIPS: Dictionary[String, Dictionary] = {
	"01_01":
	{
		"Spine": "LowerBack",
		"Chest": "Spine1",
		"UpperArm": "Arm",
		"LowerArm": "ForeArm",
		"UpperLeg": "UpLeg",
		"LowerLeg": "Leg",
		"Toes": "ToeBase"
	},
	"01_03":
	{
		"Spine": "LowerBack",
		"Chest": "Spine1",
		"UpperArm": "Arm",
		"LowerArm": "ForeArm",
		"UpperLeg": "UpLeg",
		"LowerLeg": "Leg",
		"Toes": "ToeBase"
	},
	"Boxing_Toes":
	{
		"Spine": "Ab",
		"Shoulder": "Collar",
		"UpperArm": "Shoulder",
		"LowerArm": "Elbow",
		"Hand": "Wrist",
		"UpperLeg": "Hip",
		"LowerLeg": "Knee",
		"Foot": "Ankle"
	},
}
## From Godot's axes to those of a file.
const TURNS: Dictionary[BvhOptions.UpAxis, Quaternion] = {
	BvhOptions.UpAxis.Y: Quaternion.IDENTITY,
	BvhOptions.UpAxis.Z: Quaternion(0.7071067811865476, 0.0, 0.0, 0.7071067811865476),
	BvhOptions.UpAxis.X: Quaternion(0.0, 0.0, -0.7071067811865476, 0.7071067811865476),
	BvhOptions.UpAxis.Y_DOWN: Quaternion(1.0, 0.0, 0.0, 0.0),
	BvhOptions.UpAxis.Z_DOWN: Quaternion(-0.7071067811865476, 0.0, 0.0, 0.7071067811865476),
	BvhOptions.UpAxis.X_DOWN: Quaternion(0.0, 0.0, 0.7071067811865476, 0.7071067811865476),
}
const ORDERS: Dictionary[String, EulerOrder] = {
	"XYZ": EULER_ORDER_XYZ,
	"XZY": EULER_ORDER_XZY,
	"YXZ": EULER_ORDER_YXZ,
	"YZX": EULER_ORDER_YZX,
	"ZXY": EULER_ORDER_ZXY,
	"ZYX": EULER_ORDER_ZYX,
}


## Motion in metres, Y up.
class Motion:
	## Where the joints are in the rest pose.
	var rest: Dictionary[String, Vector3] = {}
	## For each frame the rotation of each joint in the world.
	var turns: Array[Dictionary] = []
	## For each frame where the hips are.
	var hips: PackedVector3Array = PackedVector3Array()


## How a file is written.
class Style:
	## A name of [constant Schemes.SCHEMES].
	var scheme: String = "CMU"
	## Length of the file's unit, m.
	var unit: float = 0.01
	## The axis that points up in the motion.
	var axis: BvhOptions.UpAxis = BvhOptions.UpAxis.Y
	## The order of the rotation channels.
	var order: String = "ZXY"
	## "same": the rest pose stands in the file's axes. "root": it stands along Y, and the hips turn
	## the person up. "stretched": all bones lie along X.
	var rest: String = "same"
	## Frames of the rest pose at the origin before the motion.
	var rest_frames: int = 0
	## Whether a joint that never moves carries the hips, 2.4 m above the ground.
	var is_below_static_joint: bool = false
	## How the person is turned: 0 upright, -90 on the back, 90 on the face, degrees about X.
	var tilt_deg: float = 0.0


## A part of one of our clips: every [param p_step]th frame.
static func motion(p_clip: String, p_first: int, p_count: int, p_step: int) -> Motion:
	var options: BvhOptions = BvhOptions.new()
	options.unit_metres = 0.01 if p_clip == "Boxing_Toes" else BvhOptions.CMU_UNIT
	options.up_axis = BvhOptions.UpAxis.Y
	var clip: BvhClip = BvhParser.parse_file("res://assets/motion/%s.bvh" % p_clip, options).clip
	var rest: PackedVector3Array = clip.rest_positions()
	var joints: Dictionary[String, int] = {}
	var found: Motion = Motion.new()
	for key: String in keys():
		joints[key] = _joint(clip, key, CLIPS[p_clip])
		found.rest[key] = rest[joints[key]]
	for step: int in p_count:
		var pose: BvhClip.Pose = clip.sample_global(p_first + step * p_step)
		var turns: Dictionary[String, Quaternion] = {}
		for key: String in joints:
			turns[key] = pose.orientations[joints[key]]
		found.turns.append(turns)
		found.hips.append(pose.positions[0])
	return found


## All joints of a person in the order of a file: all that hang on a joint follow it.
static func keys() -> PackedStringArray:
	var found: PackedStringArray = []
	for key: String in PARENTS:
		if not key in SIDED:
			found.append(key)
	for limb: PackedStringArray in [SIDED.slice(0, _ARM_PARTS), SIDED.slice(_ARM_PARTS)]:
		for side: String in ["Left", "Right"]:
			for key: String in limb:
				found.append(side + key)
	return found


## The joint that another hangs on, or an empty text.
static func parent(p_key: String) -> String:
	var side: String = "Left" if p_key.begins_with("Left") else "Right"
	var bare: String = p_key.trim_prefix("Left").trim_prefix("Right")
	var above: String = PARENTS[bare]
	return side + above if above in SIDED else above


## The text of a file.
static func text(p_motion: Motion, p_style: Style) -> String:
	var names: Dictionary[String, String] = Schemes.names(p_style.scheme)
	var clip: BvhClip = BvhClip.new()
	var joints: Array[BvhJoint] = []
	var index: Dictionary[String, int] = {"": -1}
	var frames: Dictionary[String, Quaternion] = _rest_frames(p_motion, p_style)
	if p_style.is_below_static_joint:
		joints.append(_new_joint("reference", -1, _static_place(p_style) / p_style.unit, ""))
		joints[0].channels = PackedInt32Array([BvhJoint.Channel.X_POSITION])
		index[""] = 0
	for key: String in keys():
		var above: String = parent(key)
		var offset: Vector3 = p_motion.rest[key] - p_motion.rest.get(above, p_motion.rest["Hips"])
		offset = frames.get(above, Quaternion.IDENTITY).inverse() * offset / p_style.unit
		var order: String = "" if key.ends_with("End") else p_style.order
		joints.append(_new_joint(names.get(key, ""), index[above], offset, order))
		if key == "Hips":
			joints[-1].channels = PackedInt32Array([0, 1, 2]) + joints[-1].channels
		index[key] = joints.size() - 1
		if key.ends_with("LowerArm") and names.has(key.replace("LowerArm", "Helper")):
			var helper: String = names[key.replace("LowerArm", "Helper")]
			joints.append(_new_joint(helper, index[key], offset * 0.3, p_style.order))
	clip.set_data(joints, _values(p_motion, p_style, frames, index, joints), 1.0 / 30.0)
	return BvhWriter.to_text(clip)


static func _joint(p_clip: BvhClip, p_key: String, p_names: Dictionary) -> int:
	var side: String = ""
	var bare: String = p_key
	for prefix: String in ["Left", "Right"]:
		if p_key.begins_with(prefix):
			side = prefix
			bare = p_key.trim_prefix(prefix)
	var is_end: bool = bare.ends_with("End")
	bare = bare.trim_suffix("End")
	var joint: int = p_clip.find_joint(side + p_names.get(bare, bare))
	if not is_end:
		return joint
	for child: int in p_clip.joints.size():
		if p_clip.joints[child].parent == joint:
			return child
	return joint


static func _new_joint(
	p_name: String, p_parent: int, p_offset: Vector3, p_order: String
) -> BvhJoint:
	var joint: BvhJoint = BvhJoint.new()
	joint.name = p_name
	joint.parent = p_parent
	joint.offset = p_offset
	joint.is_end_site = p_name == ""
	for axis: String in p_order:
		joint.channels.append(BvhJoint.Channel.X_ROTATION + "XYZ".find(axis))
	return joint


## What turns a joint's own axes in the file's rest pose into Godot's.
static func _rest_frames(p_motion: Motion, p_style: Style) -> Dictionary[String, Quaternion]:
	var found: Dictionary[String, Quaternion] = {}
	for key: String in keys():
		if p_style.rest == "root":
			found[key] = Quaternion.IDENTITY
		elif p_style.rest == "same":
			found[key] = TURNS[p_style.axis].inverse()
		else:
			found[key] = found.get(parent(key), Quaternion.IDENTITY)
			for child: String in keys():
				var along: Vector3 = p_motion.rest[child] - p_motion.rest[key]
				if parent(child) == key and along.length() > 0.01:
					found[key] = Quaternion(Vector3.RIGHT, along.normalized())
					break
	return found


static func _static_place(p_style: Style) -> Vector3:
	return TURNS[p_style.axis] * Vector3(0.3, 2.4, 0.0)


static func _values(
	p_motion: Motion,
	p_style: Style,
	p_frames: Dictionary[String, Quaternion],
	p_index: Dictionary[String, int],
	p_joints: Array[BvhJoint]
) -> PackedFloat64Array:
	var values: PackedFloat64Array = []
	var tilt: Quaternion = Quaternion(Vector3.RIGHT, deg_to_rad(p_style.tilt_deg))
	var height: float = p_motion.rest["Hips"].y - p_motion.rest["LeftToes"].y
	for frame: int in range(-p_style.rest_frames, p_motion.hips.size()):
		var hips: Vector3 = Vector3(0.0, height, 0.0)
		if frame >= 0:
			hips = p_motion.hips[frame] + Vector3(1.0, 0.0, 2.0)
			hips.y = lerpf(0.14, hips.y, absf(cos(deg_to_rad(p_style.tilt_deg))))
			if p_style.is_below_static_joint:
				hips += Vector3(0.02, 0.0, 0.05) * frame
		var turns: Dictionary[String, Quaternion] = {}
		for key: String in keys():
			var turn: Quaternion = tilt * p_motion.turns[frame][key] if frame >= 0 else tilt
			turns[key] = TURNS[p_style.axis] * turn * p_frames[key]
		var place: Vector3 = TURNS[p_style.axis] * hips
		if p_style.is_below_static_joint:
			place -= _static_place(p_style)
		for joint: BvhJoint in p_joints:
			_append(
				joint, p_index.find_key(p_joints.find(joint)), place / p_style.unit, turns, values
			)
	return values


## The numbers of a joint in a frame; one without a key is a helper, which never turns.
static func _append(
	p_joint: BvhJoint,
	p_key: Variant,
	p_place: Vector3,
	p_turns: Dictionary[String, Quaternion],
	r_values: PackedFloat64Array
) -> void:
	var order: String = ""
	for channel: int in p_joint.channels:
		if BvhJoint.is_rotation(channel):
			order += "XYZ"[channel - BvhJoint.Channel.X_ROTATION]
	var angles: Vector3 = Vector3.ZERO
	if p_key != null and p_key != "" and order != "":
		var above: Quaternion = p_turns.get(parent(p_key), Quaternion.IDENTITY)
		angles = Basis((above.inverse() * p_turns[p_key]).normalized()).get_euler(ORDERS[order])
	for channel: int in p_joint.channels:
		if BvhJoint.is_rotation(channel):
			r_values.append(rad_to_deg(angles[channel - BvhJoint.Channel.X_ROTATION]))
		else:
			r_values.append(p_place[channel] if order != "" else p_joint.offset[channel])
