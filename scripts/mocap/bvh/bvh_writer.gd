class_name BvhWriter
extends RefCounted
## Writes a [BvhClip] as BVH text, in the file's own axes and units.


## The text of a file with the given digits after the point. [BvhParser] reads it back to the same
## clip, up to rounding.
static func to_text(p_clip: BvhClip, p_decimals: int = 6) -> String:
	var lines: PackedStringArray = hierarchy(p_clip.joints, p_decimals)
	lines.append("MOTION")
	lines.append("Frames: %d" % p_clip.frame_count)
	lines.append("Frame Time: %.10f" % p_clip.frame_time)
	_write_rows(p_clip, _format(p_decimals), lines)
	return "\n".join(lines) + "\n"


## The lines of a skeleton: its joints and end sites, each after its parent and what hangs on it
## right after it. For who writes a file while its frames come.
static func hierarchy(p_joints: Array[BvhJoint], p_decimals: int = 6) -> PackedStringArray:
	var lines: PackedStringArray = PackedStringArray(["HIERARCHY"])
	var open: PackedInt32Array = PackedInt32Array()
	for index: int in p_joints.size():
		var joint: BvhJoint = p_joints[index]
		while not open.is_empty() and open[-1] != joint.parent:
			open.remove_at(open.size() - 1)
			lines.append("\t".repeat(open.size()) + "}")
		_write_joint(joint, open.size(), _format(p_decimals), lines)
		open.append(index)
	while not open.is_empty():
		open.remove_at(open.size() - 1)
		lines.append("\t".repeat(open.size()) + "}")
	return lines


## Writes a file. Returns OK or what went wrong.
static func save(p_clip: BvhClip, p_path: String, p_decimals: int = 6) -> Error:
	var file: FileAccess = FileAccess.open(p_path, FileAccess.WRITE)
	if file == null:
		return FileAccess.get_open_error()
	file.store_string(to_text(p_clip, p_decimals))
	return file.get_error()


static func _format(p_decimals: int) -> String:
	return "%%.%df" % p_decimals


static func _write_joint(
	p_joint: BvhJoint, p_depth: int, p_number: String, p_lines: PackedStringArray
) -> void:
	var indent: String = "\t".repeat(p_depth)
	var title: String = "ROOT " if p_joint.parent < 0 else "JOINT "
	if p_joint.is_end_site:
		title = "End Site "
	p_lines.append((indent + title + p_joint.name).rstrip(" "))
	p_lines.append(indent + "{")
	var offset: Vector3 = p_joint.offset
	var format: String = "%s\tOFFSET %s %s %s" % [indent, p_number, p_number, p_number]
	p_lines.append(format % [offset.x, offset.y, offset.z])
	if p_joint.is_end_site:
		return
	var channels: PackedStringArray = PackedStringArray()
	for channel: int in p_joint.channels:
		channels.append(BvhJoint.CHANNEL_NAMES[channel])
	var count: int = channels.size()
	p_lines.append(("%s\tCHANNELS %d %s" % [indent, count, " ".join(channels)]).rstrip(" "))


static func _write_rows(p_clip: BvhClip, p_number: String, p_lines: PackedStringArray) -> void:
	var formats: PackedStringArray = PackedStringArray()
	formats.resize(p_clip.channel_count)
	formats.fill(p_number)
	var format: String = " ".join(formats)
	for frame: int in p_clip.frame_count:
		var start: int = frame * p_clip.channel_count
		p_lines.append(format % Array(p_clip.values.slice(start, start + p_clip.channel_count)))
