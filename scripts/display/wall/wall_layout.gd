class_name WallLayout
extends RefCounted
## The screens of a station and where its viewer's eyes are: a layout file, checked.
##
## The file has the form of [OptionsFile]: lines [code]name = value[/code] below headings
## [code][station][/code] and [code][screen NAME][/code]; comments begin with ; or #. Metres are in
## the station's frame: x to the right, y up, -z ahead, from a point of the floor. See
## [LayoutReader] for all names. Pure: it knows nothing of monitors that are there.

## The eyes stay where they are.
const FIXED: String = "fixed"
## They are those of the own person.
const HEAD: String = "head"
## Distance from a wall below which an eye counts as on it, m.
const MIN_DISTANCE_M: float = 0.05
## Most screens of a station.
const MAX_SCREENS: int = 16
## Most bytes of a layout file.
const MAX_BYTES: int = 1 << 20
## Tolerance of a rectangle's corners, as a share of its size.
const _OFF: float = 1e-3
const _OFF_M: float = 0.005
const _SMALL_M: float = 0.01

## What is wrong, a line each: "FILE:LINE: ...". Empty: the layout can be shown.
var faults: PackedStringArray = []
## In the order of the file, or those of this client in the order in which they were asked for.
var screens: Array[WallScreen] = []
## Position of the eyes, m; where they are tracked, only until then.
var eye: Vector3 = Vector3(0.0, 1.7, 0.0)
## [constant FIXED], [constant HEAD] (of the own person), or the name of a tracker of XRServer.
var track: String = FIXED
## Between the eyes, m.
var eye_distance: float = 0.065
## Whether the station turns with the client's camera about all axes, as a cabin does; else the
## horizon stays level, and only the heading is the camera's.
var tilts: bool = false
## Whether each screen has a client of its own.
var is_split: bool = false
## Where the first client listens to the others, or empty.
var sync_host: String = ""
## The port of that address, UDP.
var sync_port: int = 0
## Differs between layouts: displays of a station have the same one.
var fingerprint: int = 0

var _path: String = ""


## A layout without screens. The path of its file is for messages.
func _init(p_path: String) -> void:
	_path = p_path


## Notes what is wrong in a line.
func refuse(p_line: int, p_what: String) -> void:
	faults.append("%s:%d: %s" % [_path, p_line, p_what])


## All that is wrong as one text, or empty.
func describe_faults() -> String:
	var text: String = "\n".join(faults.slice(0, OptionsFile.MAX_FAULTS))
	if faults.size() > OptionsFile.MAX_FAULTS:
		text += "\nand %d more" % (faults.size() - OptionsFile.MAX_FAULTS)
	return text


## Keeps only some screens, by their names with commas between. Returns what is wrong, or nothing.
func keep_only(p_names: String) -> String:
	if p_names == "":
		return ""
	var kept: Array[WallScreen] = []
	for name: String in p_names.split(","):
		if kept.any(func(screen: WallScreen) -> bool: return screen.name == name.strip_edges()):
			continue
		var known: PackedStringArray = []
		var before: int = kept.size()
		for screen: WallScreen in screens:
			known.append(screen.name)
			if screen.name == name.strip_edges():
				kept.append(screen)
		if kept.size() == before:
			var shown: String = ByteReader.clean(name).left(40)
			return "%s has no screen '%s'%s" % [_path, shown, Nearest.suggest(name, known)]
	screens = kept
	return ""


## Finds where the windows of all screens are, on monitors that are there. Returns what is wrong, a
## line each.
func place_on(p_monitors: Monitors) -> PackedStringArray:
	var wrong: PackedStringArray = []
	for screen: WallScreen in screens:
		if screen.monitor == "":
			continue
		var found: Rect2i = p_monitors.find(screen.monitor)
		if found.size == Vector2i.ZERO:
			var parts: Array = [_path, screen.line, screen.name, screen.monitor]
			var text: String = "%s:%d: screen %s asks for the monitor '%s', which is not there: "
			wrong.append(text % parts + p_monitors.describe())
			continue
		screen.position = found.position
		screen.size = found.size
	return wrong + find_shared_pixels()


## Which screens, all of one desktop, are at the same place of it: a line each.
func find_shared_pixels() -> PackedStringArray:
	var wrong: PackedStringArray = []
	for at: int in screens.size():
		for other: int in at:
			if screens[at].shares_pixels_with(screens[other]):
				var parts: Array = [_path, screens[at].line, screens[at].name, screens[other].name]
				var text: String = "%s:%d: screens %s and %s share pixels of the desktop: give"
				wrong.append(text % parts + " each a monitor or a place of its own")
	return wrong


## What is wrong with an eye, in the station's frame, for the screens; or an empty text.
func find_eye_fault(p_eye: Vector3) -> String:
	if not p_eye.is_finite():
		return "the eye is nowhere: its position is no number"
	for screen: WallScreen in screens:
		var distance: float = screen.seen_from(p_eye).distance
		if distance < MIN_DISTANCE_M:
			var where: String = "on" if distance > -MIN_DISTANCE_M else "behind"
			return "the eye is %s the screen %s" % [where, screen.name]
	return ""


## Notes what is wrong with what was read. [param p_eye_line] is the line that says where the eye
## is, [param p_sync_line] that which says how displays keep in step; 0: none.
func check(p_eye_line: int, p_sync_line: int) -> void:
	if not faults.is_empty():
		return
	if screens.is_empty():
		refuse(1, "there is no screen: begin one with [screen NAME]")
	for screen: WallScreen in screens:
		var fault: String = _find_fault(screen)
		if fault != "":
			refuse(screen.line, "screen %s: %s" % [screen.name, fault])
	if not faults.is_empty():
		return
	var wrong: String = find_eye_fault(eye)
	if wrong != "":
		var text: String = wrong + ", %s: move it to the front, or exchange the screen's left and "
		refuse(p_eye_line, text % eye + "right corners if it is mirrored")
	if is_split and sync_host == "":
		refuse(1, "clients of their own keep in step by sync = HOST:PORT of the first one")
	if not is_split and p_sync_line > 0:
		refuse(
			p_sync_line, "sync is for clients = each: one client is in step by itself; leave it out"
		)
	# Screens with clients of their own may be on other machines.
	if not is_split:
		faults.append_array(find_shared_pixels())


func _find_fault(p_screen: WallScreen) -> String:
	var right: Vector3 = p_screen.bottom_right - p_screen.bottom_left
	var up: Vector3 = p_screen.top_left - p_screen.bottom_left
	if minf(right.length(), up.length()) < _SMALL_M:
		return "two corners are at the same place: give three different ones, in metres"
	if right.normalized().cross(up.normalized()).length() < _OFF:
		return "its corners are in a line, so it has no area: correct one of them"
	if absf(right.normalized().dot(up.normalized())) > _OFF:
		var degrees: float = rad_to_deg(right.angle_to(up))
		var text: String = "its lower left corner has %.2f degrees: a screen is a rectangle; bend"
		return text % degrees + " what is projected by warp or mesh"
	var last: Vector3 = p_screen.bottom_right + up
	if p_screen.top_right.is_finite() and p_screen.top_right.distance_to(last) > _OFF_M:
		var off: String = "it is no rectangle: its top-right in line %d should be %.3f %.3f %.3f"
		return off % [p_screen.top_right_line, last.x, last.y, last.z]
	if p_screen.monitor == "" and mini(p_screen.size.x, p_screen.size.y) < 2:
		return "where is it? Give monitor = NUMBER, or position and size in pixels"
	if not p_screen.warp.is_empty() and not Homography.is_convex(p_screen.warp):
		return (
			"the corners of its warp cross or are mirrored: they are those of the picture's top"
			+ " left, top right, bottom right, bottom left, y downwards"
		)
	if maxf(p_screen.blend.x + p_screen.blend.y, p_screen.blend.z + p_screen.blend.w) > 1.0:
		return "its blended edges overlap: opposite ones are 1 together at most"
	return ""
