class_name BvhPoses
extends RefCounted
## Some poses of a clip, in the file's own axes and units: enough to see what body is in it.

## Maximum of frames that are looked at.
const MAX_FRAMES: int = 48


## Where all joints are in up to [constant MAX_FRAMES] frames, spread over the clip. A clip without
## frames gives its rest pose.
static func spread(p_clip: BvhClip) -> Array[PackedVector3Array]:
	var kinematics: BvhKinematics = BvhKinematics.new(p_clip.joints, p_clip.positions_add_offset)
	var count: int = mini(p_clip.frame_count, MAX_FRAMES)
	var found: Array[PackedVector3Array] = []
	for index: int in count:
		# From the middle of equal parts: a first frame is in the rest pose in many files.
		var frame: int = (2 * index + 1) * p_clip.frame_count / (2 * count)
		kinematics.solve(p_clip.values, frame * p_clip.channel_count)
		found.append(kinematics.positions())
	if count == 0:
		found.append(rest(p_clip))
	return found


## Where all joints are in the rest pose.
static func rest(p_clip: BvhClip) -> PackedVector3Array:
	var kinematics: BvhKinematics = BvhKinematics.new(p_clip.joints, p_clip.positions_add_offset)
	kinematics.rest()
	return kinematics.positions()
