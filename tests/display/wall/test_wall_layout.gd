extends TestCase
## Layout files: what is read, and what is said of what cannot be shown.

const _FRONT: String = """
[station]
eye = 0 1.7 0.5    ; m
eye-distance = 0.06
[screen front]
bottom-left = -1.5 0 -1.5
bottom-right = 1.5, 0, -1.5
top-left = -1.5 2.5 -1.5
top-right = 1.5 2.5 -1.5
position = 100 0
size = 600 500
mode = rows
blend-right = 0.2
black-level = 0.1
"""


func _read(p_text: String) -> WallLayout:
	return LayoutReader.parse(p_text.to_utf8_buffer(), "cave.cfg")


func _changed(p_from: String, p_to: String) -> String:
	is_true(_FRONT.contains(p_from), p_from)
	return _read(_FRONT.replace(p_from, p_to)).describe_faults()


func test_a_good_layout_is_read() -> void:
	var layout: WallLayout = _read(_FRONT)
	equal(layout.describe_faults(), "")
	almost_equal(layout.eye, Vector3(0.0, 1.7, 0.5), 1e-6)
	almost_equal(layout.eye_distance, 0.06, 1e-6)
	var screen: WallScreen = layout.screens[0]
	equal(screen.name, "front")
	equal(screen.position, Vector2i(100, 0))
	equal(screen.mode, StereoMode.Kind.ROWS)
	almost_equal(screen.blend.y, 0.2, 1e-6)
	almost_equal(screen.shape(), 1.2, 1e-5)
	almost_equal(screen.seen_from(layout.eye).distance, 2.0, 1e-5)


func test_bad_screens_are_named_with_line_and_remedy() -> void:
	var cases: Dictionary[Array, String] = {
		["top-left = -1.5 2.5", "top-left = 3 0"]: "cave.cfg:5: screen front: its corners are in",
		["bottom-right = 1.5, 0", "bottom-right = -1.5, 0"]: "two corners are at the same place",
		["top-left = -1.5 2.5 -1.5\n", "top-left = -1 2.5 -1.5\n"]: "is a rectangle; bend",
		["top-right = 1.5", "top-right = 1.6"]:
		"cave.cfg:5: screen front: it is no rectangle: its top-right in line 9",
		["eye = 0 1.7 0.5", "eye = 0 1.7 -2"]: "cave.cfg:3: the eye is behind the screen front",
		["eye = 0 1.7 0.5", "eye = 0 1.7 -1.5"]: "the eye is on the screen front",
		["eye = 0 1.7 0.5", "eye = 0 nan 0"]: "cave.cfg:3: eye is three numbers of metres",
		["eye = 0 1.7 0.5", "eye = 0 1.7 inf"]: "cave.cfg:3: eye is three numbers of metres",
		["size = 600 500\n", ""]: "where is it? Give monitor",
		["mode = rows", "mode = row"]: "cave.cfg:12: mode is one of mono",
		["blend-right = 0.2", "blend-right = 1.2"]: "cave.cfg:13: blend-right is a share",
		["blend-right", "blend-rigth"]: "did you mean blend-right",
		["[screen front]", "[scren front]"]: "cave.cfg:5: there is no heading [scren front]",
		["top-left = -1.5 2.5 -1.5\n", ""]: "screen front has no top-left",
		["black-level = 0.1", "warp = 0 0 1 0 0 1 1 1"]: "corners of its warp cross",
		["black-level = 0.1", "mesh = none.data"]: "the mesh none.data cannot be read",
	}
	for change: Array in cases:
		contains(_changed(change[0], change[1]), cases[change])
	contains(_read("").describe_faults(), "there is no screen")
	contains(LayoutReader.read("/nowhere.cfg").describe_faults(), "cannot be read")


func test_mirrored_corners_are_said_to_be_so() -> void:
	var text: String = _FRONT.replace("bottom-left = -1.5", "bottom-left = 1.5")
	text = text.replace("bottom-right = 1.5", "bottom-right = -1.5")
	text = text.replace("top-left = -1.5", "top-left = 1.5")
	text = text.replace("top-right = 1.5", "top-right = -1.5")
	contains(_read(text).describe_faults(), "if it is mirrored")


func test_absent_monitors_and_shared_pixels() -> void:
	var monitors: Monitors = Monitors.new()
	monitors.places = [Rect2i(0, 0, 640, 480), Rect2i(640, 0, 640, 480)]
	var listed: String = "Monitors: 2\n 0: +*left 640/169x480/127+0+0  screen\n"
	monitors.take_names(listed + " 1: +b 640/1x480/1+640+0\n")
	var layout: WallLayout = _read(_FRONT.replace("position = 100 0", "monitor = b"))
	equal(layout.place_on(monitors).size(), 0)
	equal(layout.screens[0].position, Vector2i(640, 0))
	equal(layout.screens[0].size, Vector2i(640, 480))
	layout = _read(_FRONT.replace("position = 100 0", "monitor = 2"))
	var said: String = "\n".join(layout.place_on(monitors))
	contains(said, "screen front asks for the monitor '2', which is not there")
	contains(said, "1 (b) 640x480+640+0")
	var second: String = _FRONT.get_slice("[screen front]", 1)
	contains(_read(_FRONT + "[screen other]" + second).describe_faults(), "share pixels")


func test_screens_of_several_machines_may_be_at_the_same_place() -> void:
	var second: String = _FRONT.get_slice("[screen front]", 1)
	var split: String = _FRONT.replace(
		"[station]", "[station]\nclients = each\nsync = 10.0.0.1:7790"
	)
	var text: String = split + "[screen other]" + second
	var layout: WallLayout = _read(text)
	equal(layout.describe_faults(), "")
	var monitors: Monitors = Monitors.new()
	monitors.places = [Rect2i(0, 0, 1280, 800)]
	contains("\n".join(layout.place_on(monitors)), "share pixels")
	equal(layout.keep_only("other, other"), "")
	equal(layout.place_on(monitors).size(), 0)
	# Likewise where each machine has its monitor 0.
	text = text.replace("position = 100 0\nsize = 600 500", "monitor = 0")
	layout = _read(text)
	equal(layout.describe_faults(), "")
	contains("\n".join(layout.find_shared_pixels()), "screens other and front share pixels")
	equal(layout.keep_only("front"), "")
	equal(layout.place_on(monitors).size(), 0)


func test_what_would_be_ignored_is_refused() -> void:
	var twice: String = _read(_FRONT + "[station]\neye = 0 1 0\n").describe_faults()
	contains(twice, "cave.cfg:15: there are two [station], see line 2")
	var alone: String = _changed("[station]", "[station]\nsync = 127.0.0.1:7790")
	contains(alone, "cave.cfg:3: sync is for clients = each")


func test_only_some_screens() -> void:
	var layout: WallLayout = _read(_FRONT)
	contains(layout.keep_only("frnt"), "did you mean front")
	equal(layout.keep_only("front"), "")
	equal(layout.screens.size(), 1)


func test_noise_is_no_layout_and_no_crash() -> void:
	var noise: RandomNumberGenerator = RandomNumberGenerator.new()
	noise.seed = 7
	for _round: int in 200:
		var bytes: PackedByteArray = _FRONT.to_utf8_buffer()
		for _change: int in 6:
			bytes[noise.randi_range(0, bytes.size() - 1)] = noise.randi_range(1, 126)
		for screen: WallScreen in LayoutReader.parse(bytes, "noise").screens:
			is_true(screen.bottom_left.is_finite())


func test_the_example_is_sound() -> void:
	var layout: WallLayout = LayoutReader.read("res://scenes/display/wall/cave.cfg")
	equal(layout.describe_faults(), "")
	equal(layout.screens.size(), 4)


func test_the_examples_of_stations_are_sound() -> void:
	var names: PackedStringArray = DirAccess.get_files_at("res://examples/stations")
	var screens: Dictionary[String, int] = {}
	for name: String in names:
		if name.get_extension() == "cfg":
			var layout: WallLayout = LayoutReader.read("res://examples/stations".path_join(name))
			equal(layout.describe_faults(), "")
			screens[name] = layout.screens.size()
	equal(screens, {"cave.cfg": 4, "projectors.cfg": 2, "seat.cfg": 3} as Dictionary[String, int])
