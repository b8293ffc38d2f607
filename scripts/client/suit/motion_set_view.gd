class_name MotionSetView
extends Control
## What a wearer sees of a [MotionSetSession] from a few metres away: the own figure in a mirror, in
## large words what to do, how much of it there is, and what comes next.

## Heights of the words, as shares of the view's height.
const _WORDS: float = 0.075
const _SMALL: float = 0.035
const _STATES: Dictionary[GuidedRecording.State, String] = {
	GuidedRecording.State.WAITING: "Waiting for your motion",
	GuidedRecording.State.READY: "Get ready",
	GuidedRecording.State.RUNNING: "Now",
	GuidedRecording.State.DONE: "Done",
}

var _session: MotionSetSession = null
var _mirror: MirrorView = MirrorView.new()
var _figure: StickFigureView = StickFigureView.new()
var _size: BodySize = null
var _state: Label = UiWords.new(Vector2(0.47, 0.05), Vector2(0.98, 0.18))
var _what: Label = UiWords.new(Vector2(0.47, 0.18), Vector2(0.98, 0.58))
var _bar: ProgressBar = ProgressBar.new()
var _next: Label = UiWords.new(Vector2(0.47, 0.67), Vector2(0.98, 0.8))
var _news: Label = UiWords.new(Vector2(0.47, 0.8), Vector2(0.98, 0.97))


## Shows a session.
func _init(p_session: MotionSetSession) -> void:
	_session = p_session
	_session.said.connect(_on_said)
	set_anchors_preset(Control.PRESET_FULL_RECT)
	var back: ColorRect = ColorRect.new()
	back.color = UiStyle.SCREEN
	back.set_anchors_preset(Control.PRESET_FULL_RECT)
	add_child(back)
	_mirror.anchor_right = 0.45
	_mirror.anchor_bottom = 1.0
	_mirror.stage.add_child(_figure)
	add_child(_mirror)
	_bar.anchor_left = 0.47
	_bar.anchor_right = 0.98
	_bar.anchor_top = 0.59
	_bar.anchor_bottom = 0.65
	_bar.max_value = 1.0
	_bar.step = 0.001
	for child: Control in [_state, _what, _bar, _next, _news]:
		add_child(child)
	resized.connect(_fit)


func _process(p_delta: float) -> void:
	var guide: GuidedRecording = _session.guide
	_state.text = _STATES[guide.state]
	if guide.state == GuidedRecording.State.READY:
		_state.text += ": %d" % ceili(guide.countdown_s())
	if guide.state != GuidedRecording.State.WAITING and guide.is_lost():
		_state.text = "No motion comes"
	_what.text = guide.phase().words if guide.phase() != null else ""
	_bar.value = guide.progress
	var after: GuidedPhase = guide.next_phase()
	_next.text = "Then: %s" % after.words if after != null else "Escape ends it, S leaves this out"
	if _session.newest != null and _session.source != null:
		_show_figure(_session.newest, p_delta)


func _unhandled_key_input(p_event: InputEvent) -> void:
	var key: InputEventKey = p_event as InputEventKey
	if key == null or not key.pressed or key.echo:
		return
	if key.keycode == KEY_S:
		_session.guide.skip()
	elif key.keycode == KEY_ESCAPE:
		_session.stop()


## The words that are shown, for those who look for them.
func text() -> String:
	return "\n".join([_state.text, _what.text, _next.text, _news.text])


func _show_figure(p_pose: PoseSample, p_delta: float) -> void:
	if _size == null:
		_size = _session.source.get_body()
		_mirror.begin(_size.height)
	_figure.show_pose(p_pose, _size, PackedInt32Array())
	var heading: float = Rotations.facing_of(p_pose.orientation(Limbs.CHEST))
	_mirror.follow(p_pose.root, 0.0, heading, p_delta)


func _on_said(p_text: String) -> void:
	_news.text = p_text


func _fit() -> void:
	for label: Label in [_state, _what, _next, _news]:
		var share: float = _WORDS if label in [_state, _what] else _SMALL
		label.add_theme_font_size_override("font_size", maxi(roundi(share * size.y), 8))
