class_name BvhHandedness
extends RefCounted
## Finds files that are mirrored, and mirrors them back.
##
## Programs with left-handed axes can write their numbers as if the axes were right-handed. The
## person is then that of a mirror, with the names of the true one: what is called left lies on the
## right of where the toes point. Toes point forward and knees bend backwards, seen from the line
## between the hip joints, whichever way the person walks, turns or lies: that tells.

## Bend of the knees, as the mean sine of their angle, from which on they count in full.
const FULL_BEND: float = 0.2
## Evidence, from -2 (mirrored) to 2, below which a file is mirrored. Of 177 clips of other people
## all but those guessed from video by a network were above 0.37, and so below -0.37 mirrored.
const MIRRORED: float = -0.25


## Mirrors a clip back if it is mirrored, and says so in its notes. Its up axis must be known.
static func settle(p_clip: BvhClip, p_map: HumanoidMap) -> void:
	var poses: Array[PackedVector3Array] = BvhPoses.spread(p_clip, BvhAnatomy.MAX_FRAMES)
	var left: PackedInt32Array = p_map.leg(Limbs.LEFT_UPPER_LEG)
	if evidence(poses, left, p_map.leg(Limbs.RIGHT_UPPER_LEG)) >= MIRRORED:
		return
	mirror(p_clip)
	p_clip.notes.append(
		(
			(
				"%s: toes and knees point backwards, as left and right are exchanged in the file"
				+ " (left-handed axes?); it was mirrored"
			)
			% p_clip.source_name
		)
	)


## How much toes and knees speak for what is called left being left: 2 all, -2 all against it, 0
## nothing. A leg is hip joint, knee, ankle and a point in front of the ankle, -1 if unknown.
static func evidence(
	p_poses: Array[PackedVector3Array], p_left: PackedInt32Array, p_right: PackedInt32Array
) -> float:
	var toes: float = 0.0
	var bend: float = 0.0
	var bends: float = 0.0
	var shares: float = 2.0 * p_poses.size()
	for pose: PackedVector3Array in p_poses:
		var across: Vector3 = (pose[p_left[0]] - pose[p_right[0]]).normalized()
		for leg: PackedInt32Array in [p_left, p_right]:
			var thigh: Vector3 = (pose[leg[1]] - pose[leg[0]]).normalized()
			var shank: Vector3 = (pose[leg[2]] - pose[leg[1]]).normalized()
			var axis: Vector3 = thigh.cross(shank)
			bend += axis.dot(across)
			bends += axis.length()
			if leg[3] >= 0:
				var forward: Vector3 = across.cross(-shank).normalized()
				toes += (pose[leg[3]] - pose[leg[2]]).normalized().dot(forward) / shares
	if bends <= 0.0:
		return toes
	return toes + bend / bends * minf(bends / shares / FULL_BEND, 1.0)


## Mirrors a clip along a level axis of its file, names kept.
static func mirror(p_clip: BvhClip) -> void:
	var is_x_up: bool = p_clip.up_axis in [BvhOptions.UpAxis.X, BvhOptions.UpAxis.X_DOWN]
	var axis: int = Vector3.AXIS_Z if is_x_up else Vector3.AXIS_X
	var columns: PackedInt32Array = []
	for joint: BvhJoint in p_clip.joints:
		joint.offset[axis] = -joint.offset[axis]
		for position: int in joint.channels.size():
			var channel: int = joint.channels[position]
			var is_along: bool = channel == BvhJoint.Channel.X_POSITION + axis
			var turns: bool = BvhJoint.is_rotation(channel)
			if is_along or turns and channel != BvhJoint.Channel.X_ROTATION + axis:
				columns.append(joint.first_channel + position)
	var values: PackedFloat64Array = p_clip.values
	for frame: int in p_clip.frame_count:
		for column: int in columns:
			var at: int = frame * p_clip.channel_count + column
			values[at] = -values[at]
	p_clip.set_data(p_clip.joints, values, p_clip.frame_time)
