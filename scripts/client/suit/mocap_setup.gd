class_name MocapSetup
extends ClientPart
## Everything about motion capture at a client: the sources that the options ask for, calibrations,
## and the panel with devices and sensors, which a key opens.

## Input action that opens and closes the panel.
const ACTION: StringName = &"toggle_devices"
## Input action that opens the panel's mirror.
const MIRROR_ACTION: StringName = &"toggle_mirror"
## Input action that sets the headings of all suits anew.
const HEADING_ACTION: StringName = &"reset_heading"
## Period of updating the list of devices, s.
const _PERIOD_S: float = 0.25
## Frames between two looks at how far the own body is from its motion.
const _TETHER_FRAMES: int = 10

const _PANEL: PackedScene = preload("res://scenes/mocap/panel/device_panel.tscn")

## The sources.
var inputs: MotionInputs = MotionInputs.new()
## The people whose motion is sent; null before [method open].
var people: ClientPeople = null

var _listed_s: float = 0.0
# The time of the last frame, s.
var _now_s: float = 0.0
# The motion that is sent of a source where it is not the source's own: it is fitted to a headset,
# or carried by a walker's legs.
var _fitted: Dictionary[MotionSource, MotionSource] = {}
# Made when it is opened for the first time: most clients never open it.
var _panel: DevicePanel = null
var _mirror: ClientMirror = null
# Asks whether somebody who tries out wants to leave.
var _leave_prompt: UiPrompt = null
var _cues: GuideCues = null
var _discovery: SourceDiscovery = SourceDiscovery.new()
# The calibration that is heard.
var _guided: SuitSource = null
# Above the rest of the screen.
var _layer: CanvasLayer = CanvasLayer.new()
var _reports: WearerReports = null


func _ready() -> void:
	_layer.name = "Layer"
	_layer.layer = 2
	add_child(_layer)
	_cues = GuideCues.new()
	add_child(_cues)


func _physics_process(_delta: float) -> void:
	if people != null:
		people.sample_in_world()


func _unhandled_key_input(p_event: InputEvent) -> void:
	# The mirror's key is that of the panel, with another one held.
	if people != null and p_event.is_action_pressed(MIRROR_ACTION):
		_show_panel(true)
		_panel.show_mirror()
		get_viewport().set_input_as_handled()
	elif people != null and p_event.is_action_pressed(ACTION):
		_show_panel(not is_panel_open())
		get_viewport().set_input_as_handled()
	elif people != null and p_event.is_action_pressed(HEADING_ACTION):
		for suit: SuitSource in inputs.wearers:
			inputs.calibration.reset_heading(suit, _now_s)
		get_viewport().set_input_as_handled()


## Opens all sources.
func open(p_context: ClientContext) -> String:
	super(p_context)
	var options: Options = context.options
	people = ClientPeople.new(context.link, options)
	context.people = people
	context.link.joined.connect(people.begin)
	_reports = WearerReports.new(context.link, inputs, calibrate)
	inputs.appeared.connect(_on_appeared)
	inputs.vanished.connect(_on_vanished)
	if context.is_headset_worn():
		inputs.make_default = context.headset.make_body
	elif options.text("display") == DisplayNames.HMD:
		inputs.awaits_headset = not ClientContext.is_headless()
	var fault: String = inputs.open(options)
	people.vmc_out = inputs.vmc_out
	if fault == "" and context.try_out != null:
		context.try_out.changed.connect(_on_try_out_changed)
		_show_panel(true)
		_panel.show_mirror()
	elif fault == "" and options.is_on("panel"):
		_show_panel(true)
	return fault


func begin_frame() -> void:
	# Questions, such as that of a server's key, come first.
	_layer.visible = not context.is_menu_open()
	read_sources(ClientContext.ui_s())
	_reports.advance(_now_s)
	context.hud.show_guide(guide(_now_s))


## Works out where the own bodies are in this frame.
func advance(_delta_s: float) -> void:
	context.own_bodies = {}
	if context.scene.replica.is_ready():
		context.own_bodies = people.evaluate(context.frame_usec, context.scene.replica)


func end_frame(_delta_s: float) -> void:
	if Engine.get_process_frames() % _TETHER_FRAMES == 0:
		context.hud.show_tether(context.scene.describe_tether(people.first_actor))


## Takes in what the sources say by a time, s, and shows it on the panel.
func read_sources(p_now_s: float) -> void:
	_now_s = p_now_s
	inputs.advance(p_now_s)
	people.take_samples()
	_let_guide_be_heard()
	_discovery.advance(p_now_s)
	if is_panel_open():
		_mirror.advance(p_now_s)
	if is_panel_open() and p_now_s > _listed_s + _PERIOD_S:
		_listed_s = p_now_s
		_panel.show_devices(inputs.list_devices())
		(_panel.get_node("%Webcam") as WebcamView).show_pictures(inputs.streams.list_pictures())
		_show_sources()


## What the wearer is to see at a time, s, while the panel does not show it.
func guide(p_now_s: float) -> String:
	return "" if is_panel_open() else inputs.guide(p_now_s)


## Whether the panel is open.
func is_panel_open() -> bool:
	return _panel != null and _panel.visible


## Calibrates one of the people, as an instructor asks. The outcome goes to
## [code]func(accepted: bool, text: String)[/code].
func calibrate(p_index: int, p_kind: int, p_now_s: float, p_answer: Callable = Callable()) -> void:
	var source: MotionSource = people.source_of(p_index) if people != null else null
	if source == null or not ClientCalibration.orders().values().has(p_kind):
		Log.limited("mocap", "asked", "no calibration %d of person %d" % [p_kind, p_index])
		if p_answer.is_valid():
			p_answer.call(false, "has no person %d, or no calibration %d" % [p_index, p_kind])
		return
	source = ClientMotion.innermost(source)
	if p_kind != ClientCalibration.HEADING:
		inputs.calibrate(source, p_kind as CalibrationGuide.Kind, p_now_s, p_answer)
	elif source is SuitSource:
		inputs.calibration.reset_heading(source as SuitSource, p_now_s, p_answer)
	elif p_answer.is_valid():
		p_answer.call(false, "wears no sensors whose headings could be reset")


## Closes all devices.
func close() -> void:
	_discovery.stop()
	if people != null:
		people.stop()
	inputs.close()


func _listen(p_is_wanted: bool) -> void:
	if not p_is_wanted:
		_discovery.stop()
	elif not _discovery.is_listening():
		var own: PackedInt32Array = inputs.streams.list_ports()
		if inputs.mvn != null:
			own.append(inputs.mvn.receiver.get_port())
		_discovery.start(own)


func _show_sources() -> void:
	if not _discovery.is_listening():
		return
	_panel.sources().show_heard(_discovery.list())
	var choices: PackedInt32Array = []
	for group: LimbFusion.Group in LimbFusion.Group.values():
		choices.append(inputs.people.choice(group))
	_panel.sources().show_groups(LimbFusion.NAMES, choices, inputs.list_sources())


## Takes a source that was heard: its port is free again before.
func _open_source(p_source: String) -> void:
	_discovery.stop()
	_panel.sources().show_fault(inputs.open_source(p_source))
	_listen(true)


func _choose_group(p_group: int, p_number: int) -> void:
	_panel.sources().show_fault(inputs.people.choose(p_group as LimbFusion.Group, p_number))


func _let_guide_be_heard() -> void:
	if not inputs.wearers.has(_guided):
		_guided = null
	if _guided == null or _guided.process.phase == CalibrationProcess.Phase.IDLE:
		for wearer: SuitSource in inputs.wearers:
			if wearer.process.phase != CalibrationProcess.Phase.IDLE:
				_guided = wearer
				if not wearer.calibrated.is_connected(_cues.conclude):
					wearer.calibrated.connect(_cues.conclude)
	if _guided != null:
		_cues.follow(_guided.process)


func _show_panel(p_shows: bool) -> void:
	if not p_shows and context.try_out != null and context.try_out.is_before_session():
		# There is nothing behind it.
		_ask_to_leave()
		return
	if _panel == null:
		_panel = _PANEL.instantiate()
		_panel.close_wanted.connect(_show_panel.bind(false))
		_panel.profile_changed.connect(_on_profile_changed)
		_panel.sources().listening_wanted.connect(_listen)
		_panel.sources().source_wanted.connect(_open_source)
		_panel.sources().group_chosen.connect(_choose_group)
		_layer.add_child(_panel)
		_mirror = ClientMirror.new(context, inputs, _panel.mirror())
	_panel.visible = p_shows
	_listed_s = 0.0
	if p_shows:
		_panel.show_suits(inputs.wearers)


func _ask_to_leave() -> void:
	if _leave_prompt == null:
		_leave_prompt = UiPrompt.new("You have not joined")
		_leave_prompt.set_answers(["Stay", "Leave"])
		_leave_prompt.answered.connect(_on_leave_answered)
		_layer.add_child(_leave_prompt)
	_leave_prompt.ask("Nobody has seen you yet. Leave the program?")


func _on_leave_answered(p_answer: int) -> void:
	if p_answer == 1:
		context.leave_wanted.emit(StateStream.EXIT_DONE)
	else:
		_panel.show_mirror()


func _on_try_out_changed() -> void:
	if not context.try_out.is_before_session():
		_show_panel(false)


func _on_profile_changed(p_suit: int) -> void:
	if p_suit < inputs.wearers.size():
		var source: MotionSource = inputs.wearers[p_suit]
		people.measure(_fitted.get(source, source))


func _on_appeared(p_source: MotionSource, p_name: String) -> void:
	var headset: ClientHeadset = context.headset
	# Who walks by a stick has the headset's head already.
	var is_free: bool = headset != null and headset.fused == null and headset.body == null
	if is_free and not p_source is WalkerSource:
		_fitted[p_source] = headset.fit(p_source)
	if inputs.people.carries(p_source):
		_fitted[p_source] = WalkedLegs.new(_fitted.get(p_source, p_source))
	people.add(_fitted.get(p_source, p_source), p_name)


func _on_vanished(p_source: MotionSource) -> void:
	people.remove(_fitted.get(p_source, p_source))
	var fitted: MotionSource = _fitted.get(p_source)
	if fitted is WalkedLegs:
		fitted = (fitted as WalkedLegs).first
	_fitted.erase(p_source)
	if fitted is FusedSource and context.headset != null:
		context.headset.fused = null
