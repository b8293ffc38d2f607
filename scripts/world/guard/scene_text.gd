class_name SceneText
extends RefCounted
## Reads a text scene (.tscn) as the editor saves it into sections, by a grammar of its own, without
## the engine's loader: nothing is made, looked up or run. [LevelReader] decides what may be made.
##
## Each tag and each property stands on one line; whatever goes over several lines (dictionaries,
## source texts) is refused.

## Largest file, bytes.
const MAX_BYTES: int = 4 << 20
## Most lines of a file.
const MAX_LINES: int = 120_000
## Format of text scenes that is understood.
const FORMAT: int = 3

const _TAGS: PackedStringArray = ["gd_scene", "ext_resource", "sub_resource", "node"]
const _ATTRIBUTE: String = (
	' ([a-z_]{1,20})=("[^"\\\\]*"|-?[0-9]{1,18}|ExtResource\\("[^"\\\\]*"\\)'
	+ "|PackedStringArray\\([^()\\[\\]]*\\)|\\[[^()\\[\\]]*\\])"
)
const _HIGH_BITS: int = -9187201950435737472  # 0x8080808080808080

static var _attribute: RegEx = RegEx.create_from_string(_ATTRIBUTE)
static var _tag: RegEx = RegEx.create_from_string("^\\[([a-z_]{1,20})(.*)\\]$")
static var _file_tag: RegEx = RegEx.create_from_string("(?m)^\\[ext_resource [^\\n]*")
static var _name: RegEx = RegEx.create_from_string("^[A-Za-z_][A-Za-z0-9_/]{0,79}$")

## The sections, in the order of the file.
var sections: Array[SceneSection] = []
## Refuses a tag before what is below it is read: [code]func(section: SceneSection) -> String[/code]
## says why, or nothing.
var tag_check: Callable = Callable()
## Looked for in the whole text before anything else, so that what is hostile is named at once,
## however much stands before it: an expression, whose first group is shown, and what is said of it.
var early_checks: Array[Array] = []
## Why it cannot be read, or an empty text.
var fault: String = ""
## The line of the fault, from 1; 0 if it is the whole file.
var fault_line: int = 0

var _values: SceneValues = SceneValues.new()


## Reads the bytes of a file. Returns whether it can be read.
func read(p_bytes: PackedByteArray) -> bool:
	sections.clear()
	fault = ""
	fault_line = 0
	var text: String = _decode(p_bytes)
	if fault != "" or not _look_ahead(text):
		return false
	var lines: PackedStringArray = text.split("\n")
	var section: SceneSection = null
	for index: int in lines.size():
		var line: String = lines[index].strip_edges()
		if line == "" or line[0] == ";":
			continue
		if line[0] == "[":
			section = _read_tag(line, index + 1)
			sections.append(section)
			if fault == "" and tag_check.is_valid():
				_refuse(tag_check.call(section))
		else:
			_read_property(section, line, index + 1)
		if fault != "":
			fault_line = index + 1
			return false
	if sections.is_empty() or sections[0].tag != "gd_scene":
		return _refuse("it is no text scene")
	return true


## Whether bytes are UTF-8, without the engine's decoder, which reports an error for each that is
## not.
static func is_utf8(p_bytes: PackedByteArray) -> bool:
	var padded: PackedByteArray = p_bytes.duplicate()
	padded.resize(ceili(p_bytes.size() / 8.0) * 8)
	var seen: int = 0
	for word: int in padded.to_int64_array():
		seen |= word
	if seen & _HIGH_BITS == 0:
		return true
	var more: int = 0
	var least: int = 0
	var code: int = 0
	for byte: int in p_bytes:
		if more > 0:
			code = (code << 6) | (byte & 0x3F)
			more -= 1
			var is_end: bool = more == 0
			if byte & 0xC0 != 0x80 or (is_end and (code < least or code > 0x10FFFF)):
				return false
			if is_end and code >= 0xD800 and code <= 0xDFFF:
				return false
		elif byte >= 0x80:
			if byte < 0xC2 or byte > 0xF4:
				return false
			more = 1 if byte < 0xE0 else (2 if byte < 0xF0 else 3)
			code = byte & (0x3F >> more)
			least = [0x80, 0x800, 0x10000][more - 1]
	return more == 0


## Makes the early checks. Returns whether all is well so far.
func _look_ahead(p_text: String) -> bool:
	for check: Array in early_checks:
		var found: RegExMatch = (check[0] as RegEx).search(p_text)
		if found != null:
			_refuse((check[1] as String) % ByteReader.clean(found.get_string(1).left(60)))
			fault_line = p_text.count("\n", 0, found.get_start()) + 1
			return false
	if not tag_check.is_valid():
		return true
	for found: RegExMatch in _file_tag.search_all(p_text):
		_refuse(tag_check.call(_read_tag(found.get_string().strip_edges(), 0)))
		if fault != "":
			fault_line = p_text.count("\n", 0, found.get_start()) + 1
			return false
	return true


## The text of a file; refuses what is too large, binary, or no UTF-8.
func _decode(p_bytes: PackedByteArray) -> String:
	if p_bytes.size() > MAX_BYTES:
		_refuse("it has %d bytes, %d are the most" % [p_bytes.size(), MAX_BYTES])
		return ""
	var start: PackedByteArray = p_bytes.slice(0, 4)
	if start == "RSRC".to_ascii_buffer() or start == "RSCC".to_ascii_buffer():
		_refuse("it is a binary scene; only text scenes are read")
		return ""
	if p_bytes.has(0) or not is_utf8(p_bytes):
		_refuse("it is no text in UTF-8")
		return ""
	if p_bytes.count(10) > MAX_LINES:
		_refuse("it has more than %d lines" % MAX_LINES)
		return ""
	return p_bytes.get_string_from_utf8()


func _read_tag(p_line: String, p_number: int) -> SceneSection:
	var section: SceneSection = SceneSection.new()
	section.line = p_number
	var found: RegExMatch = _tag.search(p_line)
	if found == null:
		_refuse("a tag is broken: '%s'" % ByteReader.clean(p_line.left(40)))
		return section
	section.tag = found.get_string(1)
	if not _TAGS.has(section.tag):
		_refuse("it has a [%s]; levels have none" % section.tag)
		return section
	var rest: String = found.get_string(2)
	var end: int = 0
	for part: RegExMatch in _attribute.search_all(rest):
		if part.get_start() != end:
			break
		end = part.get_end()
		var key: String = part.get_string(1)
		if section.attributes.has(key):
			_refuse("a [%s] has '%s' twice" % [section.tag, key])
		section.attributes[key] = _values.read(part.get_string(2))
		if _values.fault != "":
			_refuse(_values.fault)
	if end != rest.length():
		_refuse("a [%s] is broken at '%s'" % [section.tag, ByteReader.clean(rest.substr(end, 40))])
	return section


func _read_property(p_section: SceneSection, p_line: String, p_number: int) -> void:
	var at: int = p_line.find("=")
	var name: String = p_line.left(maxi(at, 0)).strip_edges()
	if at < 0 or _name.search(name) == null:
		_refuse("'%s' is no property" % ByteReader.clean(p_line.left(40)))
		return
	if p_section == null or p_section.tag == "gd_scene" or p_section.tag == "ext_resource":
		_refuse("'%s' stands where nothing can be set" % name)
		return
	if p_section.names.size() >= 64 or p_section.names.has(name):
		_refuse("'%s' is set twice, or there are too many properties" % name)
		return
	p_section.values.append(_values.read(p_line.substr(at + 1).strip_edges()))
	if _values.fault != "":
		_refuse("'%s': %s" % [name, _values.fault])
		return
	p_section.names.append(name)
	p_section.lines.append(p_number)


func _refuse(p_why: String) -> bool:
	if fault == "":
		fault = p_why
	return false
