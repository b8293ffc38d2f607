class_name WallDisplay
extends DisplayMode
## Shows the world on the screens of a station: several monitors around a seat, projectors on a
## curved screen, the walls of a CAVE. Each screen is a window through which the world is seen from
## the viewer's eyes, fixed or tracked.
##
## The station stands where the client's camera is: the eye's first position of the layout is the
## camera's, and straight ahead is the camera's heading; the horizon stays level, but for a cabin
## ([member WallLayout.tilts]). One process shows all screens, or each has a client of its own
## ([member WallLayout.is_split]), kept in step by [StationSync]. The first window keeps texts and
## menus. The engine has no genlock: displays of several machines show the same moment, but not in
## the same refresh of their panels. While walls are shown, suns have their simple shadows
## ([ObliqueSuns]).

const _NO_LAYOUT: String = (
	"walls need a layout of their screens: name it with --layout=FILE, such as"
	+ " examples/stations/seat.cfg"
)

## The station; null before [method set_up].
var layout: WallLayout = null
## Whether each eye gets the other one's picture, on all screens.
var swap_eyes: bool = false:
	set(p_value):
		swap_eyes = p_value
		for pane: WallPane in _panes:
			pane.swap_eyes = p_value

var _panes: Array[WallPane] = []
var _kept: Dictionary[StringName, Variant] = {}
var _window: Window = null
var _eye: Vector3 = Vector3.ZERO
var _right: Vector3 = Vector3.RIGHT
var _is_eye_lost: bool = false
var _test: TestPicture.Kind = TestPicture.Kind.NONE
var _sync: StationSync = null
var _suns: ObliqueSuns = ObliqueSuns.new()
var _lost_tracker_s: float = 0.0


## Reads a layout; [param p_screens] are the names of the screens of this client, all if it is
## empty. Returns what is wrong, or an empty text.
func set_up(p_path: String, p_screens: String = "") -> String:
	if p_path == "":
		return _NO_LAYOUT
	layout = LayoutReader.read(p_path)
	var fault: String = layout.describe_faults()
	if fault != "":
		return fault
	var first: String = layout.screens[0].name
	fault = layout.keep_only(p_screens)
	if fault != "":
		return fault
	if layout.sync_host != "" and layout.is_split:
		var leads: bool = layout.screens.any(
			func(screen: WallScreen) -> bool: return screen.name == first
		)
		_sync = StationSync.new(layout.fingerprint, leads)
	_eye = layout.eye
	return ""


func open() -> String:
	if layout == null:
		return _NO_LAYOUT
	if DisplayServer.get_name() == "headless":
		return "walls need a display: start without --headless"
	if camera == null or not camera.is_inside_tree():
		return "walls need a camera of the client"
	var wrong: PackedStringArray = layout.place_on(Monitors.of_this_machine())
	if not wrong.is_empty():
		return "\n".join(wrong)
	if _sync != null:
		var fault: String = _sync.open(layout.sync_host, layout.sync_port)
		if fault != "":
			return fault
	_window = camera.get_window()
	_keep_window()
	for screen: WallScreen in layout.screens:
		var pane: WallPane = WallPane.new()
		add_child(pane)
		pane.open(screen, _window if _panes.is_empty() else _add_window(screen))
		pane.swap_eyes = swap_eyes
		_panes.append(pane)
	_suns.begin(get_tree())
	return ""


func close() -> void:
	if _sync != null:
		_sync.close()
	_suns.end()
	if _window == null:
		return
	for child: Node in get_children():
		remove_child(child)
		child.queue_free()
	_panes.clear()
	for property: StringName in _kept:
		_window.set(property, _kept[property])
	_kept.clear()
	_window = null


## Moves the eyes to a position in the station, m, the right one along an axis. Where a number is
## not finite or the position is behind a screen, the last good one stays, and the user gets one
## notice.
func set_eye(p_eye: Vector3, p_right: Vector3 = Vector3.RIGHT) -> void:
	var fault: String = layout.find_eye_fault(p_eye)
	if fault == "" and (not p_right.is_finite() or p_right.length() < 0.1):
		fault = "the eyes have no direction"
	if fault == "":
		_eye = p_eye
		_right = p_right.normalized()
		if _is_eye_lost:
			_is_eye_lost = false
			notified.emit("The viewer's eyes are tracked again")
	elif not _is_eye_lost:
		_is_eye_lost = true
		notified.emit(fault.left(1).to_upper() + fault.substr(1) + ": the last good place is kept")


## Where the eyes are, in the station's frame, m.
func eye() -> Vector3:
	return _eye


## Where the station is in the world.
func station() -> Transform3D:
	var from: Transform3D = camera.get_camera_transform()
	if _sync != null and _sync.follows():
		return _sync.leader_place().mount
	return mount_at(from, layout.eye, layout.tilts)


## Transform in the world of a station whose first eye position is at a camera.
static func mount_at(p_camera: Transform3D, p_eye: Vector3, p_tilts: bool) -> Transform3D:
	var turn: Basis = p_camera.basis.orthonormalized()
	if not p_tilts:
		var ahead: Vector3 = -turn.z
		# Straight up or down, the top of the picture is ahead.
		if Vector2(ahead.x, ahead.z).length() < 0.01:
			ahead = turn.y * -signf(ahead.y)
		turn = Basis(Vector3.UP, atan2(-ahead.x, -ahead.z))
	return Transform3D(turn, p_camera.origin - turn * p_eye)


## The tick that all displays of the station show at a moment, where this client by itself would
## show [param p_tick] of so many a second. [param p_at_usec] is of Time.get_ticks_usec().
func agree(p_tick: float, p_at_usec: int, p_rate: float) -> float:
	if _sync == null or p_tick < 0.0:
		return p_tick
	return _sync.agree(p_tick, p_at_usec, p_rate)


## Shows a test picture on all screens: a number of [enum TestPicture.Kind]; 0: the world.
func show_test_picture(p_index: int) -> void:
	_test = posmod(p_index, TestPicture.Kind.size()) as TestPicture.Kind
	for pane: WallPane in _panes:
		pane.show_test(_test)
	notified.emit("On the walls: " + TestPicture.TITLES[_test])


## Shows the next test picture, and after the last one the world.
func next_test_picture() -> void:
	show_test_picture(_test + 1)


## Gives each eye the other one's picture.
func swap() -> void:
	swap_eyes = not swap_eyes
	notified.emit("The eyes are swapped" if swap_eyes else "The eyes are as they were")


func report() -> Dictionary:
	var names: PackedStringArray = []
	# Also of a station that has been closed, as when the program ends.
	for screen: WallScreen in layout.screens:
		names.append(screen.name)
	var found: Dictionary = {"display": "wall", "screens": names, "eye": [_eye.x, _eye.y, _eye.z]}
	found["swap_eyes"] = swap_eyes
	if _sync != null:
		found["sync"] = _sync.report()
	return found


func _exit_tree() -> void:
	close()


func _process(_delta: float) -> void:
	if _window == null or camera == null or not camera.is_inside_tree():
		return
	if _sync != null and _sync.follows():
		# The viewer is the first client's.
		var leader: StationMessage = _sync.leader_place()
		set_eye(leader.eye, leader.right)
	elif layout.track != WallLayout.FIXED and layout.track != WallLayout.HEAD:
		_follow_tracker()
	var mount: Transform3D = station()
	if _sync != null:
		# Only now the camera is where it is at the tick that was agreed on.
		_sync.tell(mount, _eye, _right)
	for pane: WallPane in _panes:
		pane.follow(camera, mount, _eye, _right, layout.eye_distance)


## A tracker of XRServer stands for the viewer's head, in the station's frame.
func _follow_tracker() -> void:
	var eyes: Variant = _tracked_eyes(XRServer.get_tracker(layout.track))
	var now_s: float = Time.get_ticks_msec() * 1e-3
	if eyes != null:
		_lost_tracker_s = -1.0
		set_eye((eyes as Transform3D).origin, (eyes as Transform3D).basis.x)
	elif _lost_tracker_s >= 0.0 and now_s - _lost_tracker_s > 5.0:
		_lost_tracker_s = INF
		notified.emit("No tracker '%s' tells where the eyes are: check its source" % layout.track)
	elif _lost_tracker_s <= 0.0:
		_lost_tracker_s = now_s


## Between the eyes, x to the right, in the station's frame; null: not tracked.
static func _tracked_eyes(p_tracker: XRTracker) -> Variant:
	var body: XRBodyTracker = p_tracker as XRBodyTracker
	if body != null:
		# Its pose is the root's: on the floor, or at the hips.
		var flags: int = body.get_joint_flags(XRBodyTracker.JOINT_HEAD)
		var needed: int = (
			XRBodyTracker.JOINT_FLAG_POSITION_VALID | XRBodyTracker.JOINT_FLAG_ORIENTATION_VALID
		)
		if not body.has_tracking_data or flags & needed != needed:
			return null
		var head: Transform3D = body.get_joint_transform(XRBodyTracker.JOINT_HEAD)
		if not head.is_finite() or is_zero_approx(head.basis.determinant()):
			return null
		head.basis = head.basis.orthonormalized()
		head.basis *= Basis(HumanoidAxes.of_limb(Limbs.HEAD).inverse())
		# Its front is +Z; the eyes look along -Z.
		return head * Transform3D(Basis(Vector3.UP, PI), OrbitCamera.EYES)
	var tracker: XRPositionalTracker = p_tracker as XRPositionalTracker
	var pose: XRPose = tracker.get_pose(&"default") if tracker != null else null
	if pose == null or not pose.has_tracking_data:
		return null
	return pose.transform


func _keep_window() -> void:
	for property: StringName in [
		&"mode", &"borderless", &"size", &"position", &"disable_3d", &"content_scale_mode"
	]:
		_kept[property] = _window.get(property)
	_window.mode = Window.MODE_WINDOWED
	_window.borderless = true
	_window.position = layout.screens[0].position
	_window.size = layout.screens[0].size
	_window.disable_3d = true
	_window.content_scale_mode = Window.CONTENT_SCALE_MODE_DISABLED


func _add_window(p_screen: WallScreen) -> Window:
	var window: Window = Window.new()
	window.visible = false
	window.force_native = true
	window.borderless = true
	window.disable_3d = true
	window.title = "%s - %s" % [_window.title, p_screen.name]
	window.initial_position = Window.WINDOW_INITIAL_POSITION_ABSOLUTE
	window.position = p_screen.position
	window.size = p_screen.size
	window.close_requested.connect(
		func() -> void: failed.emit("The window of the screen %s was closed" % p_screen.name)
	)
	window.window_input.connect(_pass_on)
	add_child(window)
	window.show()
	# At first the engine keeps a window within one monitor, but a screen may be several.
	window.position = p_screen.position
	return window


## Keys that are pressed in any of the windows are the client's.
func _pass_on(p_event: InputEvent) -> void:
	if p_event is InputEventKey and _window != null:
		_window.push_input(p_event)
