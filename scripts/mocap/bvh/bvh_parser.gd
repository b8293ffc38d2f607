class_name BvhParser
extends RefCounted
## Reads BVH files, the text format of most motion capture libraries (thesis section 11.3).
##
## It accepts what real files have: channels in any order and number, positions on any joint,
## several or no End Sites, keywords in any case, names with spaces and colons, tabs, every line
## ending, comments, a byte order mark, wrapped rows. It refuses, naming file and line, whatever
## would have to be guessed: words that are no numbers, rows of another length, more or fewer frames
## than declared, a second ROOT. The result is either a whole clip or an error. All
## methods may be called from any thread.


## What reading a file gave: a whole clip, or the reason why there is none.
class Result:
	## The clip, or null if the file could not be read.
	var clip: BvhClip = null
	## Why not, in one line: "walk.bvh:17: expected 'OFFSET' with 3 numbers, found 'OFFSET 1 x 3'".
	## Empty if there is a clip.
	var error: String = ""

	## Whether there is a clip.
	func is_ok() -> bool:
		return clip != null


## Reads a file. [param p_path] may be absolute or a [code]res://[/code] or [code]user://[/code]
## path.
static func parse_file(p_path: String, p_options: BvhOptions = null) -> Result:
	var options: BvhOptions = p_options if p_options != null else BvhOptions.new()
	var name: String = "(no name)" if p_path.is_empty() else p_path.trim_suffix("/").get_file()
	if not p_path.is_empty() and DirAccess.dir_exists_absolute(p_path):
		return _failed("%s: expected a BVH file, found a folder" % name)
	var file: FileAccess = FileAccess.open(p_path, FileAccess.READ)
	if file == null:
		var reason: String = error_string(FileAccess.get_open_error()).to_lower()
		return _failed("%s: expected a readable file, found none (%s)" % [name, reason])
	var size: int = file.get_length()
	if size > options.max_bytes:
		return _failed("%s: expected at most %d bytes, found %d" % [name, options.max_bytes, size])
	return parse_bytes(file.get_buffer(size), name, options)


## Reads the bytes of a file; [param p_source] is its name in errors.
static func parse_bytes(
	p_bytes: PackedByteArray, p_source: String = "text", p_options: BvhOptions = null
) -> Result:
	if p_bytes.find(0) >= 0:
		var found: String = "a zero byte"
		if p_bytes.size() > 1 and p_bytes[0] + p_bytes[1] == 0xFF + 0xFE:
			found = "UTF-16"
		return _failed("%s:1: expected UTF-8 text, found %s" % [p_source, found])
	return parse_text(BvhText.decode(p_bytes), p_source, p_options)


## Reads the text of a file; [param p_source] is its name in errors.
static func parse_text(
	p_text: String, p_source: String = "text", p_options: BvhOptions = null
) -> Result:
	var options: BvhOptions = p_options if p_options != null else BvhOptions.new()
	var lexer: BvhLexer = BvhLexer.new(p_text, p_source)
	var hierarchy: BvhHierarchyReader = BvhHierarchyReader.new(lexer, options)
	if not hierarchy.read():
		return _failed(lexer.error)
	var motion: BvhMotionReader = BvhMotionReader.new(lexer, hierarchy.channel_count)
	if not motion.read():
		return _failed(lexer.error)
	var clip: BvhClip = BvhClip.new()
	clip.source_name = p_source
	clip.positions_add_offset = options.positions_add_offset
	clip.set_data(hierarchy.joints, motion.values, motion.frame_time)
	if not motion.note.is_empty():
		clip.notes.append(motion.note)
	BvhGuess.settle(clip, options)
	var result: Result = Result.new()
	result.clip = clip
	return result


static func _failed(p_error: String) -> Result:
	var result: Result = Result.new()
	result.error = p_error
	return result
