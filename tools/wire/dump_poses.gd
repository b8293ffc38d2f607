extends SceneTree
## Writes the poses of motion files, as the coding of people is trained and measured on them.
##
## [code]godot --headless --script res://tools/wire/dump_poses.gd -- OUTPUT FILE.bvh...[/code]
## For each file: u32 number of ticks (60 a second), then for each tick 3 floats (root, m) and
## 16 x 4 floats (x, y, z, w of each limb's rotation in the world), little-endian.

const TICKS_PER_SECOND: float = 60.0


func _init() -> void:
	var arguments: PackedStringArray = OS.get_cmdline_user_args()
	if arguments.size() < 2:
		printerr("expected: OUTPUT FILE.bvh...")
		quit(2)
		return
	var file: FileAccess = FileAccess.open(arguments[0], FileAccess.WRITE)
	if file == null:
		printerr("cannot write %s" % arguments[0])
		quit(1)
		return
	for path: String in arguments.slice(1):
		var source: BvhSource = BvhSource.new()
		source.open(path)
		if source.error != "":
			printerr("%s: %s" % [path, source.error])
			quit(1)
			return
		_write(source, file)
	quit(0)


func _write(p_source: BvhSource, p_file: FileAccess) -> void:
	var ticks: int = floori(p_source.rig.clip.duration() * TICKS_PER_SECOND)
	p_file.store_32(ticks)
	for tick: int in ticks:
		var pose: PoseSample = p_source.pose_at(tick / TICKS_PER_SECOND)
		for value: float in [pose.root.x, pose.root.y, pose.root.z]:
			p_file.store_float(value)
		p_file.store_buffer(pose.orientations.to_byte_array())
