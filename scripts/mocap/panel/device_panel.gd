class_name DevicePanel
extends Control
## The client's screen for motion capture: devices, sensors, who wears them, calibration.
##
## It knows only suits ([SuitSource]) and devices as dictionaries ([constant DeviceList.KEYS]).
## Everything works with the keyboard alone; the keys are on the buttons.

## It is to be closed.
signal close_wanted
## A person's data changed: name, size, mounts or calibration. Who is the number of the suit.
signal profile_changed(p_suit: int)

## Period of updating the stats, s.
const PERIOD_S: float = 0.2
## How long somebody who is alone can read a result before it is accepted or dropped, s.
const READ_S: float = 6.0

## Below this width, px, views and calibration stand below the tables instead of beside them.
const BESIDE_PX: float = 1200.0

## Where people's data are kept.
@export_dir var folder: String = CalibrationStore.FOLDER
## Whether it advances the suits; otherwise somebody else calls [method SuitSource.advance].
@export var drives: bool = false

@export var _rows: Control
@export var _middle: BoxContainer
@export var _person: PersonBox
@export var _devices: DeviceList
@export var _sensors: SensorTable
@export var _raw: PreviewView
@export var _calibrated: PreviewView
@export var _box: CalibrationBox
@export var _sheet: BodySheet
@export var _sources: SourceSheet
@export var _mirror: MirrorSheet
@export var _mirror_button: Button
@export var _sources_button: Button
@export var _status: Label
@export var _close: Button

## Returns the time, s; it must be the clock of the caller of [method SuitSource.advance].
var clock: Callable = func() -> float: return Time.get_ticks_usec() / 1e6

var _suits: Array[SuitSource] = []
var _sheets: SheetStack = null
var _at: int = 0
var _store: CalibrationStore = null
var _boxes_view: SensorBoxesView = null
var _figure_view: StickFigureView = null
var _guide: GuideView = null
var _draft: MapDraft = MapDraft.new()
var _gesture: ShakeGesture = ShakeGesture.new()
var _seen_frame: SensorFrame = null
# When the present result is accepted or dropped, s; negative while there is none.
var _decided_s: float = -1.0
var _stats_due_s: float = 0.0
var _fault: String = ""


func _ready() -> void:
	_store = CalibrationStore.new(folder)
	_boxes_view = SensorBoxesView.new()
	_figure_view = StickFigureView.new()
	_raw.stage.add_child(_boxes_view)
	_calibrated.stage.add_child(_figure_view)
	_figure_view.visible = false
	_guide = GuideView.new()
	_guide.set_anchors_preset(Control.PRESET_FULL_RECT)
	add_child(_guide)
	_close.pressed.connect(close_wanted.emit)
	_box.start_wanted.connect(start_calibration)
	_box.accept_wanted.connect(_accept)
	_box.cancel_wanted.connect(func() -> void: suit().refuse_calibration())
	_box.exchange_wanted.connect(_exchange)
	_box.assignment_wanted.connect(_assign)
	_box.undo_wanted.connect(_undo)
	_box.keep_wanted.connect(_keep_changes)
	_sensors.mount_chosen.connect(_move_sensor)
	_person.name_entered.connect(_rename)
	_person.person_chosen.connect(_take_person)
	_person.height_changed.connect(_set_height)
	_sheets = SheetStack.new([_sheet, _sources, _mirror], _mirror)
	_sheets.changed.connect(_on_sheet_changed)
	_person.body_wanted.connect(_toggle_body)
	_person.suits().item_selected.connect(choose_suit)
	_sheet.measured.connect(_measure)
	_sources_button.text = InputKeys.label("Sources", &"toggle_source_sheet")
	_sources_button.pressed.connect(_sheets.toggle.bind(_sources))
	_mirror_button.text = InputKeys.label("Mirror", &"toggle_mirror")
	_mirror_button.pressed.connect(show_mirror)
	_mirror.sources_wanted.connect(_sheets.toggle.bind(_sources))
	show_devices([])
	resized.connect(_fit)
	_fit()
	_refresh()


## Shows suits, one for each person. Those that the caller adds to the array later are shown too.
func show_suits(p_suits: Array[SuitSource]) -> void:
	_suits = p_suits
	_at = clampi(_at, 0, maxi(_suits.size() - 1, 0))
	_refresh()
	if is_visible_in_tree():
		_sensors.grab_focus()


## Shows devices: dictionaries with [constant DeviceList.KEYS] and perhaps "advice".
func show_devices(p_devices: Array[Dictionary]) -> void:
	_devices.show_devices(p_devices)


## The sheet of sources: who sends what, and who gives which limbs.
func sources() -> SourceSheet:
	return _sources


## The sheet with the mirror.
func mirror() -> MirrorSheet:
	return _mirror


## Opens the mirror.
func show_mirror() -> void:
	if not _mirror.visible:
		_sheets.toggle(_mirror)


## The suit that is shown, or null.
func suit() -> SuitSource:
	return _suits[_at] if _at < _suits.size() else null


## Shows another suit.
func choose_suit(p_at: int) -> void:
	_at = clampi(p_at, 0, maxi(_suits.size() - 1, 0))
	_fault = ""
	_gesture.clear()
	_refresh()


## Begins a calibration of the suit that is shown.
func start_calibration(p_kind: CalibrationGuide.Kind) -> void:
	if suit() == null:
		_fault = "no suit is there to be calibrated"
	else:
		suit().process.options = _box.options()
		_fault = suit().start_calibration(p_kind, _now_s())
		# The panel shows its result.
		if _mirror.visible and _fault == "":
			_sheets.toggle(_mirror)
	_show_status()


func _process(_delta: float) -> void:
	if is_visible_in_tree() and _person.suits().item_count != _suits.size():
		choose_suit(_at)
	if drives:
		for each: SuitSource in _suits:
			each.advance(_now_s())
	_figure_view.visible = suit() != null
	if suit() == null:
		_guide.visible = false
		_box.show_idle("")
	if not is_visible_in_tree() or suit() == null:
		return
	_draft.follow(suit())
	_show_views()
	_box.show_changes(_draft.is_changed())
	_box.show_process(suit().process, suit().watch.messages())
	_guide.ends = _decide_alone() if _box.is_alone() else ""
	_guide.show_process(suit().process)
	if suit().process.phase == CalibrationProcess.Phase.IDLE and not suit().watch.swaps.is_empty():
		_box.offer_exchange(suit().watch.swaps[0])
	if _now_s() >= _stats_due_s:
		_stats_due_s = _now_s() + PERIOD_S
		_show_stats()


func _input(p_event: InputEvent) -> void:
	if not is_visible_in_tree():
		return
	var process: CalibrationProcess = suit().process if suit() != null else null
	var cancels: bool = p_event.is_action_pressed(&"ui_cancel")
	if cancels and _sheets.current() != null:
		_sheets.toggle(_sheets.current())
	elif p_event.is_action_pressed(&"toggle_source_sheet"):
		_sheets.toggle(_sources)
	elif p_event.is_action_pressed(&"toggle_body_sheet"):
		_toggle_body()
	elif p_event.is_action_pressed(&"toggle_mirror"):
		_sheets.toggle(_mirror)
	elif not _box.take_input(p_event, process):
		if not cancels:
			return
		close_wanted.emit()
	get_viewport().set_input_as_handled()


## Nobody is at the keys: a result that is good enough is accepted by itself, after the wearer had
## time to read it. Returns what will happen, for people.
func _decide_alone() -> String:
	var result: CalibrationResult = suit().process.result
	if suit().process.phase != CalibrationProcess.Phase.DONE or result == null:
		_decided_s = -1.0
		return ""
	if _decided_s < 0.0:
		_decided_s = _now_s() + READ_S
	if result.calibration == null and result.error == "":
		return ""  # A fit check: what it found is applied by hand.
	var accepts: bool = result.calibration != null and result.is_acceptable()
	if _now_s() >= _decided_s:
		if accepts:
			_accept()
		else:
			suit().refuse_calibration()
	return "Accepted" if accepts else "Shake a hand to try again"


func _fit() -> void:
	_middle.vertical = size.x < BESIDE_PX


func _show_views() -> void:
	var newest: SensorFrame = suit().newest_frame
	if newest != null:
		_boxes_view.show_frame(newest, _mounts(), suit().get_body())
	if suit().newest_pose != null:
		var trouble: PackedInt32Array = SuitWords.limbs_in_trouble(suit())
		_figure_view.show_pose(suit().newest_pose, suit().get_body(), trouble)
	else:
		# Nobody knows yet how the wearer stands: a neutral figure.
		var neutral: PoseSample = CalibrationGuide.countdown(ResetPose.Kind.N).pose_at(0.0)
		neutral.root = Vector3(0.0, suit().get_hip_height(), 0.0)
		neutral.details = MotionDetails.new()
		neutral.details.measured.resize(Limbs.COUNT)
		_figure_view.show_pose(neutral, suit().get_body(), PackedInt32Array())
	var is_idle: bool = suit().process.phase == CalibrationProcess.Phase.IDLE
	if newest != null and newest != _seen_frame and _box.is_alone() and is_idle:
		_seen_frame = newest
		if _gesture.add(newest):
			start_calibration(CalibrationGuide.Kind.FULL)


func _refresh() -> void:
	var list: OptionButton = _person.suits()
	list.clear()
	for each: SuitSource in _suits:
		list.add_item("%d: %s" % [list.item_count + 1, each.get_profile().name])
	list.visible = _suits.size() > 1
	if suit() == null:
		_show_status()
		return
	list.selected = _at
	_person.show_person(suit().get_profile(), _store.list())
	_sheet.show_size(suit().get_body(), _fault if _sheet.visible else "")
	_show_stats()


func _show_stats() -> void:
	_sensors.show_suit(suit())
	_show_status()


func _show_status() -> void:
	_status.text = _fault if _fault != "" else SuitWords.describe(suit())
	_status.tooltip_text = _status.text


func _mounts() -> PackedInt32Array:
	return suit().get_profile().map.of_sensors(suit().feed.list_sensors())


func _accept() -> void:
	suit().accept_calibration()
	_keep()


func _exchange(p_mounts: Vector2i) -> void:
	_draft.exchange(p_mounts)
	suit().refuse_calibration()
	_tell_of_changes("exchanged")


func _assign(p_mounts: PackedInt32Array) -> void:
	_draft.assign(p_mounts)
	suit().refuse_calibration()
	_tell_of_changes("all moved")


func _move_sensor(p_sensor: String, p_mount: int) -> void:
	_draft.move(p_sensor, p_mount)
	_tell_of_changes("moved")


func _undo() -> void:
	if _draft.undo():
		_fault = "undone"
		_refresh()


## Changes are tried at once, and kept with the next calibration that is accepted, or by a key.
func _tell_of_changes(p_what: String) -> void:
	_fault = "%s: calibrate again" % p_what
	_refresh()


func _keep_changes() -> void:
	_fault = ""
	_keep()


func _rename(p_name: String) -> void:
	if suit() == null or p_name == suit().get_profile().name:
		return
	_fault = PersonProfile.find_name_fault(p_name)
	if _fault != "":
		_show_status()
		return
	if _store.list().has(p_name):
		# Somebody who is known: their data, not this wearer's under their name.
		_take_person(p_name)
		return
	suit().rename(p_name)
	_keep_measures()


func _take_person(p_name: String) -> void:
	if suit() == null:
		return
	var profile: PersonProfile = _store.read(p_name)
	_fault = _store.error
	if profile != null:
		suit().set_profile(profile)
		profile_changed.emit(_at)
	_refresh()


func _set_height(p_metres: float) -> void:
	_resize(func(size: BodySize) -> String: return size.set_height(p_metres))


func _measure(p_name: StringName, p_metres: float) -> void:
	_resize(func(size: BodySize) -> String: return size.measure(p_name, p_metres))


## Changes the wearer's size: [code]func(size: BodySize) -> String[/code] returns what is wrong.
func _resize(p_change: Callable) -> void:
	if suit() == null:
		return
	var size_then: BodySize = suit().get_body().duplicate()
	_fault = p_change.call(size_then)
	if _fault == "":
		suit().set_body(size_then)
		_keep_measures()
	else:
		_refresh()


func _toggle_body() -> void:
	if suit() != null:
		_sheets.toggle(_sheet)


func _on_sheet_changed() -> void:
	# The mirror takes the whole screen: nothing behind it is drawn, or takes the keyboard.
	_rows.visible = _sheets.current() != _mirror
	_fault = ""
	_sources.show_fault("")
	_refresh()
	if _sheets.current() == null:
		_sensors.grab_focus()


## Keeps all of the person's data, with what was changed of where sensors are worn.
func _keep() -> void:
	_draft.accept()
	_write(suit().get_profile())


## Keeps name and measures; sensors that were moved on trial are kept as they were.
func _keep_measures() -> void:
	_draft.follow(suit())
	var profile: PersonProfile = suit().get_profile().duplicate()
	profile.map = _draft.kept()
	_write(profile)


func _write(p_profile: PersonProfile) -> void:
	if not _store.write(p_profile):
		_fault = _store.error
	profile_changed.emit(_at)
	_refresh()


func _now_s() -> float:
	return clock.call()
