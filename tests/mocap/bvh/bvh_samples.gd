extends RefCounted
## Small BVH files and random clips for the tests.

const SIMPLE: String = """HIERARCHY
ROOT Hips
{
	OFFSET 0 0 0
	CHANNELS 6 Xposition Yposition Zposition Zrotation Xrotation Yrotation
	JOINT Chest
	{
		OFFSET 0 50 0
		CHANNELS 3 Zrotation Xrotation Yrotation
		End Site
		{
			OFFSET 0 40 0
		}
	}
	JOINT Left Leg
	{
		OFFSET 10 0 0
		CHANNELS 1 Xrotation
		End Site
		{
			OFFSET 0 -90 0
		}
	}
}

MOTION
Frames: 3
Frame Time: 0.5
0 90 0 0 0 0 0 0 0 0
1.5 90 0 90 0 0 0 0 0 45
3 90 0 180 0 0 0 0 0 90
"""


## [constant SIMPLE] with one line, counted from 1, replaced.
static func with_line(p_number: int, p_line: String) -> String:
	var lines: PackedStringArray = SIMPLE.split("\n")
	lines[p_number - 1] = p_line
	return "\n".join(lines)


## A clip of random joints, channels and numbers.
static func random_clip(p_random: RandomNumberGenerator) -> BvhClip:
	var joints: Array[BvhJoint] = []
	var path: PackedInt32Array = PackedInt32Array()
	for index: int in p_random.randi_range(1, 20):
		var joint: BvhJoint = BvhJoint.new()
		while not path.is_empty() and path.size() > 1 and p_random.randf() < 0.4:
			path.remove_at(path.size() - 1)
		joint.parent = -1 if path.is_empty() else path[-1]
		joint.is_end_site = index > 0 and p_random.randf() < 0.2
		joint.name = "" if joint.is_end_site else _random_name(p_random, index)
		joint.offset = Vector3(
			p_random.randf_range(-90, 90), p_random.randf_range(-90, 90), p_random.randf() * 1e-3
		)
		if not joint.is_end_site:
			joint.channels = _random_channels(p_random)
			path.append(index)
		joints.append(joint)
	if joints[0].channels.is_empty():
		joints[0].channels = PackedInt32Array([BvhJoint.Channel.Y_ROTATION])
	var count: int = 0
	for joint: BvhJoint in joints:
		count += joint.channels.size()
	var values: PackedFloat64Array = PackedFloat64Array()
	for _number: int in count * p_random.randi_range(0, 6):
		values.append(p_random.randf_range(-360, 360))
	var clip: BvhClip = BvhClip.new()
	clip.set_data(joints, values, p_random.randf_range(1e-3, 0.1))
	return clip


static func _random_name(p_random: RandomNumberGenerator, p_index: int) -> String:
	var names: PackedStringArray = ["mixamorig:Hips", "Bip01 L Thigh", "JOINT", "a", "Hüfte", "#x"]
	return "j%d%s" % [p_index, names[p_random.randi() % names.size()]]


static func _random_channels(p_random: RandomNumberGenerator) -> PackedInt32Array:
	var channels: PackedInt32Array = PackedInt32Array()
	for _number: int in p_random.randi_range(0, 6):
		var channel: int = p_random.randi_range(0, BvhJoint.CHANNEL_NAMES.size() - 1)
		if not (BvhJoint.is_position(channel) and channel in channels):
			channels.append(channel)
	return channels
