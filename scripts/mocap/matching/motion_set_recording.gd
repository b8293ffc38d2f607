class_name MotionSetRecording
extends RefCounted
## What a [GuidedRecording] leaves on the disk: a folder with each stretch of motion as BVH, written
## while it comes, and the table of what is worth keeping; at the end the set.
##
## The set is made of these files by [MotionSetBuilder]: [code]./run motion-set build[/code] with
## the folder's table makes the same bytes again.

## What is added to the set's name for the folder.
const FOLDER: String = "-recording"
## The table's name.
const TABLE: String = "table.txt"
## From where comes what the wearer did not do.
const SHIPPED: String = "res://assets/motion/walker.motionset"

## What is wrong with the files, or an empty text.
var error: String = ""
## What became of it, one sentence each.
var notes: PackedStringArray = PackedStringArray()

var _out: String = ""
var _folder: String = ""
var _guide: GuidedRecording = null
var _writer: TrackWriter = null
var _table_of: int = 0


## Takes the name of the set's file. Returns why it cannot be written, or an empty text.
func open(p_out: String) -> String:
	_out = p_out
	_folder = p_out + FOLDER
	if DirAccess.dir_exists_absolute(_folder):
		return "there is a recording %s already: name another set" % _folder
	if FileAccess.file_exists(_out):
		return "there is a file %s already: name another set" % _out
	if not DirAccess.dir_exists_absolute(_folder.get_base_dir()):
		return "there is no folder %s" % _folder.get_base_dir()
	var code: Error = DirAccess.make_dir_absolute(_folder)
	if code == OK:
		# Who has walked for three minutes is not to hear then that there is no place for it.
		var file: FileAccess = FileAccess.open(_folder.path_join(TABLE), FileAccess.WRITE)
		code = OK if file != null else FileAccess.get_open_error()
	return "" if code == OK else "cannot write %s: %s" % [_folder, error_string(code)]


## The folder of the recording.
func folder() -> String:
	return _folder


## Writes from now on what the wearer of a source does.
func begin(p_guide: GuidedRecording, p_source: MotionSource) -> void:
	_guide = p_guide
	_writer = TrackWriter.new(
		p_source.get_body(), p_source.get_hip_height(), p_source.get_limb_lengths()
	)
	p_guide.track_begun.connect(_on_track_begun)
	p_guide.frame_added.connect(_writer.add)
	p_guide.track_ended.connect(_on_track_ended)


## Looks whether all is written; call it in each frame. A phase that is over is put into the table.
func advance() -> void:
	if _writer != null and error == "":
		error = _writer.error
	if _guide != null and _guide.index != _table_of:
		_table_of = _guide.index
		_write_table(_cut())


## Makes the set of what there is. Returns what is wrong, or an empty text.
func build() -> String:
	var rows: Array[MotionSetTable.Row] = _cut()
	if rows.is_empty():
		return "no set is made: no phase was recorded as it should be"
	var builder: MotionSetBuilder = MotionSetBuilder.new()
	var kept: Array[MotionSetTable.Row] = []
	for row: MotionSetTable.Row in rows:
		builder.add_table(_table_with([row]), _folder)
		if builder.error == "":
			kept.append(row)
		else:
			notes.append("A clip is left out: " + builder.error)
			builder.error = ""
	if kept.is_empty():
		return "no set is made: none of the clips can be used"
	notes.append("Clips of your own: %d." % kept.size())
	var fault: String = _fill(builder, kept)
	if fault == "":
		fault = _write_table(kept)
	if fault == "":
		fault = builder.save(_out)
	if fault == "":
		var size: int = FileAccess.get_size(_out)
		notes.append("%s is made, %.1f MB." % [_out, size / 1e6])
	return fault


## Adds what is missing to the set and to its table.
func _fill(r_builder: MotionSetBuilder, r_rows: Array[MotionSetTable.Row]) -> String:
	var own: MotionSet = MotionSet.new()
	var fault: String = own.load_bytes(r_builder.motion_set.to_bytes())
	var shipped: MotionSet = MotionSet.new()
	if fault == "":
		fault = shipped.load_file(SHIPPED)
	if fault != "":
		return fault
	var names: PackedStringArray = []
	for row: MotionSetTable.Row in MotionSetFill.find(own, shipped, SHIPPED):
		r_builder.add_table(_table_with([row]), _folder)
		if r_builder.error != "":
			return r_builder.error
		r_rows.append(row)
		names.append("%s (%s)" % [row.name, MotionSetTable.STANCES.find_key(row.stance)])
	if not names.is_empty():
		notes.append(
			"Taken from the shipped set, as you have nothing like them: %s." % ", ".join(names)
		)
	return ""


func _write_table(p_rows: Array[MotionSetTable.Row]) -> String:
	var lines: PackedStringArray = ["# file stance from_s to_s name"]
	for row: MotionSetTable.Row in p_rows:
		lines.append(row.describe())
	var path: String = _folder.path_join(TABLE)
	var file: FileAccess = FileAccess.open(path, FileAccess.WRITE)
	if file == null or not file.store_string("\n".join(lines) + "\n"):
		error = "cannot write %s: %s" % [path, error_string(FileAccess.get_open_error())]
	return error


func _cut() -> Array[MotionSetTable.Row]:
	var tracks: Array[MotionTrack] = []
	var had: Array[GuidedRecording.Take] = []
	if _guide != null:
		had = _guide.had()
	for take: GuidedRecording.Take in had:
		tracks.append_array(take.tracks)
	return ClipCutter.cut(tracks)


static func _table_with(p_rows: Array[MotionSetTable.Row]) -> MotionSetTable:
	var table: MotionSetTable = MotionSetTable.new()
	table.rows = p_rows
	return table


func _on_track_begun(p_track: MotionTrack) -> void:
	_writer.open(_folder.path_join(p_track.name + ".bvh"))


func _on_track_ended() -> void:
	_writer.close()
