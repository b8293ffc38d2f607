class_name BvhHandedness
extends RefCounted
## Finds files that are mirrored, and mirrors them back.
##
## Programs with left-handed axes can write their numbers as if the axes were right-handed. The
## person is then that of a mirror, with the names of the true one: what is called left lies on the
## right of where the toes point. Toes and knees tell ([LegFacing]), whichever way the person walks,
## turns or lies.

## Evidence, from -2 (mirrored) to 2, below which a file is mirrored. Of 177 clips of other people
## all but those guessed from video by a network were above 0.37, and so below -0.37 mirrored.
const MIRRORED: float = -0.25


## Mirrors a clip back if it is mirrored, and says so in its notes. Its up axis must be known.
static func settle(p_clip: BvhClip, p_map: HumanoidMap) -> void:
	var poses: Array[PackedVector3Array] = BvhPoses.spread(p_clip)
	var left: PackedInt32Array = p_map.leg(Limbs.LEFT_UPPER_LEG)
	if LegFacing.evidence(poses, left, p_map.leg(Limbs.RIGHT_UPPER_LEG)) >= MIRRORED:
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
