class_name Monitors
extends RefCounted
## The monitors of this machine: by number, and by name where the system tells names.

## Where each is on the desktop, pixels.
var places: Array[Rect2i] = []
## Their names, where known.
var names: PackedStringArray = []


## Those that are there.
static func of_this_machine() -> Monitors:
	var found: Monitors = Monitors.new()
	for screen: int in DisplayServer.get_screen_count():
		var at: Vector2i = DisplayServer.screen_get_position(screen)
		found.places.append(Rect2i(at, DisplayServer.screen_get_size(screen)))
	return found


## Rectangle of a monitor by its number or name; empty where there is none.
func find(p_which: String) -> Rect2i:
	if p_which.is_valid_int():
		var number: int = p_which.to_int()
		return places[number] if number >= 0 and number < places.size() else Rect2i()
	if names.is_empty():
		_ask_names()
	var at: int = names.find(p_which)
	return places[at] if at >= 0 and at < places.size() else Rect2i()


## Which there are.
func describe() -> String:
	var texts: PackedStringArray = []
	for at: int in places.size():
		var title: String = " (%s)" % names[at] if at < names.size() and names[at] != "" else ""
		var place: Rect2i = places[at]
		var parts: Array = [at, title, place.size.x, place.size.y, place.position.x]
		texts.append("%d%s %dx%d+%d" % parts + "+%d" % place.position.y)
	var hint: String = "" if not names.is_empty() else "; names are known where xrandr is installed"
	return "there are %s%s" % [", ".join(texts), hint]


## Takes names from what xrandr --listmonitors prints: [code] 0: +*NAME 640/169x1080/286+0+0 OUT
## [/code].
func take_names(p_listed: String) -> void:
	names.resize(places.size())
	var form: RegEx = RegEx.create_from_string(
		"(?m)^\\s*\\d+:\\s+\\+?\\*?(\\S+)\\s+(\\d+)/\\d+x(\\d+)/\\d+\\+(-?\\d+)\\+(-?\\d+)"
	)
	for line: RegExMatch in form.search_all(p_listed):
		var place: Rect2i = Rect2i(
			line.get_string(4).to_int(),
			line.get_string(5).to_int(),
			line.get_string(2).to_int(),
			line.get_string(3).to_int()
		)
		var at: int = places.find(place)
		if at >= 0:
			names[at] = line.get_string(1)


## The engine tells no names; the X server's own tool does.
func _ask_names() -> void:
	if DisplayServer.get_name() != "X11":
		return
	var output: Array = []
	if OS.execute("xrandr", PackedStringArray(["--listmonitors"]), output) != 0:
		return
	take_names(output[0])
