class_name LayoutReader
extends RefCounted
## Reads the lines of a layout file into a [WallLayout].
##
## [code][station][/code]: [code]eye[/code] (x y z, m), [code]track[/code] (fixed, head, or a
## tracker's name), [code]eye-distance[/code] (m), [code]follow[/code] (heading, or all: as a cabin
## turns), [code]clients[/code] (one, or each: one for each screen), [code]sync[/code] (HOST:PORT of
## the first client).
## [code][screen NAME][/code]: [code]bottom-left[/code], [code]bottom-right[/code],
## [code]top-left[/code], [code]top-right[/code] (x y z, m; the last may be left out),
## [code]monitor[/code] (number or name) or [code]position[/code] and [code]size[/code] (x y,
## pixels), [code]mode[/code] (mono or one of [constant StereoMode.NAMES]),
## [code]swap-eyes[/code], [code]warp[/code] (four corners x y, 0..1) or [code]mesh[/code] (a file,
## see [WarpMesh]), [code]blend-left[/code], [code]-right[/code], [code]-top[/code],
## [code]-bottom[/code] (shares), [code]gamma[/code], [code]black-level[/code] (0..1).

const _STATION: PackedStringArray = ["eye", "track", "eye-distance", "follow", "clients", "sync"]
const _SCREEN: PackedStringArray = [
	"bottom-left",
	"bottom-right",
	"top-left",
	"top-right",
	"monitor",
	"position",
	"size",
	"mode",
	"swap-eyes",
	"warp",
	"mesh",
	"blend-left",
	"blend-right",
	"blend-top",
	"blend-bottom",
	"gamma",
	"black-level",
]
const _CORNERS: PackedStringArray = ["bottom-left", "bottom-right", "top-left"]
const _MAX_PIXELS: float = 32768.0
const _MAX_M: float = 1000.0

# The line that says where the eye is.
var _eye_line: int = 1
# The line that says how displays keep in step; 0: none.
var _sync_line: int = 0
var _layout: WallLayout = null
var _folder: String = ""
var _screen: WallScreen = null
var _known: PackedStringArray = []
var _given: Dictionary[String, int] = {}
var _line: int = 0
var _station_line: int = 0


## Takes where to put what is read, and the folder of the file.
func _init(p_layout: WallLayout, p_folder: String) -> void:
	_layout = p_layout
	_folder = p_folder


## Reads and checks a file.
static func read(p_path: String) -> WallLayout:
	var file: FileAccess = FileAccess.open(p_path, FileAccess.READ)
	if file == null:
		var found: WallLayout = WallLayout.new(p_path)
		var why: String = error_string(FileAccess.get_open_error())
		found.faults.append("the layout %s cannot be read: %s" % [p_path, why])
		return found
	return parse(file.get_buffer(WallLayout.MAX_BYTES + 1), p_path)


## Reads and checks the bytes of a file; the path is for messages, and where meshes are.
static func parse(p_bytes: PackedByteArray, p_path: String) -> WallLayout:
	var found: WallLayout = WallLayout.new(p_path)
	if p_bytes.size() > WallLayout.MAX_BYTES or p_bytes.has(0):
		found.refuse(1, "a layout is a text of at most %d bytes" % WallLayout.MAX_BYTES)
		return found
	found.fingerprint = hash(p_bytes)
	var reader: LayoutReader = LayoutReader.new(found, p_path.get_base_dir())
	reader._take(p_bytes.get_string_from_utf8())
	found.check(reader._eye_line, reader._sync_line)
	return found


## Reads a text.
func _take(p_text: String) -> void:
	for raw: String in p_text.split("\n"):
		_line += 1
		var text: String = raw.strip_edges()
		if text == "" or text[0] == ";" or text[0] == "#":
			continue
		if text[0] == "[":
			_finish_screen()
			_take_heading(text)
		else:
			_take_line(text.get_slice(" ;", 0).get_slice(" #", 0))
	_finish_screen()


func _refuse(p_what: String) -> void:
	_layout.refuse(_line, p_what)


func _take_heading(p_text: String) -> void:
	_given.clear()
	var heading: String = p_text.trim_prefix("[").trim_suffix("]").strip_edges()
	_known = _STATION
	if heading == "station" and p_text.ends_with("]"):
		if _station_line > 0:
			var text: String = "there are two [station], see line %d: put all of it below one"
			_refuse(text % _station_line)
		_station_line = _line
		return
	_known = _SCREEN
	_screen = WallScreen.new()
	_screen.line = _line
	_screen.name = heading.trim_prefix("screen").strip_edges()
	var is_named: bool = heading.begins_with("screen ") and _screen.name.is_valid_filename()
	if not is_named or _screen.name.contains(",") or not p_text.ends_with("]"):
		var shown: String = ByteReader.clean(p_text).left(60)
		_refuse("there is no heading %s: write [station] or [screen NAME]" % shown)
	for other: WallScreen in _layout.screens:
		if other.name == _screen.name:
			_refuse("there are two screens %s, see line %d" % [_screen.name, other.line])
	if _layout.screens.size() >= WallLayout.MAX_SCREENS:
		_refuse("a station has %d screens at most" % WallLayout.MAX_SCREENS)


func _take_line(p_text: String) -> void:
	var equals: int = p_text.find("=")
	var name: String = p_text.left(maxi(equals, 0)).strip_edges()
	var value: String = p_text.substr(equals + 1).strip_edges()
	if value.length() > 1 and value.begins_with('"') and value.ends_with('"'):
		value = value.substr(1, value.length() - 2)
	if equals < 0:
		_refuse("write name = value, found '%s'" % ByteReader.clean(p_text).left(60))
	elif _known.is_empty():
		_refuse("begin with [station] or [screen NAME]")
	elif not _known.has(name):
		var shown: String = ByteReader.clean(name).left(40)
		_refuse("there is no %s%s" % [shown, Nearest.suggest(name, _known)])
	elif _given.has(name):
		_refuse("%s is given twice, see line %d" % [name, _given[name]])
	else:
		_given[name] = _line
		var fault: String = ""
		if _known == _STATION:
			fault = _take_station(name, value)
		else:
			fault = _take_screen(name, value)
		if fault != "":
			_refuse("%s %s, found '%s'" % [name, fault, ByteReader.clean(value).left(60)])


func _take_station(p_name: String, p_value: String) -> String:
	match p_name:
		"eye":
			_eye_line = _line
			var place: PackedFloat64Array = _numbers(p_value, 3, _MAX_M)
			if place.is_empty():
				return "is three numbers of metres: x to the right, y up, -z ahead"
			_layout.eye = Vector3(place[0], place[1], place[2])
		"track":
			if p_value == "":
				return "is fixed, head, or the name of a tracker"
			_layout.track = p_value
		"eye-distance":
			var distance: PackedFloat64Array = _numbers(p_value, 1, 1.0)
			if distance.is_empty() or distance[0] < 0.0:
				return "is 0 to 1 m, usually 0.065"
			_layout.eye_distance = distance[0]
		"follow":
			if not p_value in ["heading", "all"]:
				return "is heading or all"
			_layout.tilts = p_value == "all"
		"clients":
			if not p_value in ["one", "each"]:
				return "is one or each"
			_layout.is_split = p_value == "each"
		"sync":
			_sync_line = _line
			return _take_sync(p_value)
	return ""


func _take_sync(p_value: String) -> String:
	var host: String = p_value.get_slice(":", 0)
	var port: String = p_value.get_slice(":", 1)
	var is_port: bool = port.is_valid_int() and port.to_int() > 0 and port.to_int() < 65536
	if p_value.count(":") != 1 or not host.is_valid_ip_address() or not is_port:
		return "is the address of the first client, such as 127.0.0.1:7790"
	_layout.sync_host = host
	_layout.sync_port = port.to_int()
	return ""


func _take_screen(p_name: String, p_value: String) -> String:
	match p_name:
		"monitor":
			_screen.monitor = p_value
			return "is a number or a name" if p_value == "" else ""
		"mode":
			var mode: int = StereoMode.find(p_value)
			_screen.mode = maxi(mode, 0) as StereoMode.Kind
			return "is one of " + ", ".join(StereoMode.NAMES) if mode < 0 else ""
		"swap-eyes":
			_screen.swap_eyes = p_value == "yes"
			return "" if p_value in ["yes", "no"] else "is yes or no"
		"mesh":
			_screen.mesh = WarpMesh.read(_folder.path_join(p_value))
			if _screen.mesh.error != "":
				_refuse(_screen.mesh.error)
			return ""
		"position", "size":
			return _take_pixels(p_name, p_value)
		"warp":
			return _take_warp(p_value)
		"gamma", "black-level":
			return _take_light(p_name, p_value)
	if p_name.begins_with("blend-"):
		var share: PackedFloat64Array = _numbers(p_value, 1, 1.0)
		if share.is_empty() or share[0] < 0.0:
			return "is a share of the picture, 0 to 1"
		_screen.blend[WallScreen.EDGES.find(p_name.trim_prefix("blend-"))] = share[0]
		return ""
	return _take_corner(p_name, p_value)


func _take_corner(p_name: String, p_value: String) -> String:
	var place: PackedFloat64Array = _numbers(p_value, 3, _MAX_M)
	if place.is_empty():
		return "is three numbers of metres: x to the right, y up, -z ahead"
	var corner: Vector3 = Vector3(place[0], place[1], place[2])
	match p_name:
		"bottom-left":
			_screen.bottom_left = corner
		"bottom-right":
			_screen.bottom_right = corner
		"top-left":
			_screen.top_left = corner
		"top-right":
			_screen.top_right = corner
			_screen.top_right_line = _line
	return ""


func _take_pixels(p_name: String, p_value: String) -> String:
	var pixels: PackedFloat64Array = _numbers(p_value, 2, _MAX_PIXELS)
	if pixels.is_empty() or p_name == "size" and minf(pixels[0], pixels[1]) < 2.0:
		return "is two numbers of pixels of the desktop"
	var found: Vector2i = Vector2i(roundi(pixels[0]), roundi(pixels[1]))
	if p_name == "size":
		_screen.size = found
	else:
		_screen.position = found
	return ""


func _take_warp(p_value: String) -> String:
	var found: PackedFloat64Array = _numbers(p_value, 8, 4.0)
	if found.is_empty():
		return (
			"is where the picture's corners are in the window, 0 to 1, y downwards: x y of top"
			+ " left, top right, bottom right, bottom left"
		)
	for at: int in 4:
		_screen.warp.append(Vector2(found[2 * at], found[2 * at + 1]))
	return ""


func _take_light(p_name: String, p_value: String) -> String:
	var found: PackedFloat64Array = _numbers(p_value, 1, 4.0)
	if p_name == "gamma":
		if found.is_empty() or found[0] < 1.0:
			return "is a number from 1 to 4, usually 2.2"
		_screen.gamma = found[0]
	elif found.is_empty() or found[0] < 0.0 or found[0] > 0.5:
		return "is a value from 0 to 0.5"
	else:
		_screen.black_level = found[0]
	return ""


func _finish_screen() -> void:
	if _screen == null:
		return
	var missing: PackedStringArray = []
	for corner: String in _CORNERS:
		if not _given.has(corner):
			missing.append(corner)
	if not missing.is_empty():
		_layout.refuse(
			_screen.line, "screen %s has no %s" % [_screen.name, " and no ".join(missing)]
		)
	if _screen.mesh != null and not _screen.warp.is_empty():
		_layout.refuse(_screen.line, "screen %s has warp and mesh: leave one" % _screen.name)
	_layout.screens.append(_screen)
	_screen = null


## A number of finite numbers with spaces or commas between; empty if it is anything else.
static func _numbers(p_text: String, p_count: int, p_max: float) -> PackedFloat64Array:
	var words: PackedStringArray = p_text.replace(",", " ").split(" ", false)
	var found: PackedFloat64Array = []
	for word: String in words:
		var value: float = word.to_float()
		if not word.is_valid_float() or not is_finite(value) or absf(value) > p_max:
			return []
		found.append(value)
	return found if found.size() == p_count else PackedFloat64Array()
