extends RefCounted
## Bytes of motion sets: parts of the shipped one.


## A set of those clips of the shipped one whose names begin so.
static func of(p_names: PackedStringArray) -> PackedByteArray:
	var shipped: MotionSet = MotionSet.new()
	shipped.load_file(WalkerPose.DEFAULT_SET)
	var made: MotionSet = MotionSet.new()
	for clip: int in shipped.get_clip_count():
		for name: String in p_names:
			if shipped.get_clip_name(clip).begins_with(name):
				made.add_clip_of(shipped, clip)
	return made.to_bytes()


## A set of a few clips by which somebody can walk.
static func small() -> PackedByteArray:
	return of(["stand", "slow walk 05_01"])


## A set of so many bytes or a little less, of the shipped clips again and again.
static func large(p_bytes: int) -> PackedByteArray:
	var shipped: MotionSet = MotionSet.new()
	shipped.load_file(WalkerPose.DEFAULT_SET)
	var made: MotionSet = MotionSet.new()
	var size: int = 8
	var clip: int = 0
	while true:
		size += shipped.get_clip_frame_count(clip) * 153 + shipped.get_clip_name(clip).length() + 14
		if size > p_bytes:
			return made.to_bytes()
		made.add_clip_of(shipped, clip)
		clip = (clip + 1) % shipped.get_clip_count()
	return []
