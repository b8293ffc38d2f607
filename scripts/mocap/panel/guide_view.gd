class_name GuideView
extends Control
## What a wearer sees of a calibration from three metres away: a figure that takes the pose or makes
## the movement, the seconds that are left, and few large words.

## Height of the words and of the seconds, as shares of the view's height.
const _WORDS: float = 0.075
const _SECONDS: float = 0.3
## Words that are too many become smaller, down to this.
const _SMALLEST: float = 0.035
## What each stage is called.
const _STAGES: Dictionary[CalibrationProcess.Phase, String] = {
	CalibrationProcess.Phase.COUNTDOWN: "Get ready",
	CalibrationProcess.Phase.HOLD: "Hold still",
	CalibrationProcess.Phase.MOVE: "Move",
}
const _COLORS: Dictionary[CalibrationProcess.Phase, Color] = {
	CalibrationProcess.Phase.COUNTDOWN: Color(1.0, 0.85, 0.35),
	CalibrationProcess.Phase.HOLD: Color(0.45, 0.9, 0.5),
	CalibrationProcess.Phase.MOVE: Color(0.5, 0.75, 1.0),
}
## Of the result, by [method CalibrationResult.word].
const _RESULTS: Dictionary[String, Color] = {
	"good": Color(0.45, 0.9, 0.5), "fair": Color(1.0, 0.85, 0.35), "poor": Color(1.0, 0.5, 0.35)
}

## What becomes of a result by itself, for people; an empty text where somebody presses a key.
var ends: String = ""

var _picture: PreviewView = PreviewView.new()
var _figure: StickFigureView = StickFigureView.new()
var _stage: Label = UiWords.new(Vector2(0.46, 0.06), Vector2(0.98, 0.2))
var _seconds: Label = UiWords.new(Vector2(0.46, 0.2), Vector2(0.98, 0.56))
var _words: Label = UiWords.new(Vector2(0.46, 0.56), Vector2(0.98, 0.97))
var _size: BodySize = BodySize.of_hip_height(0.95)
var _standing: StandingHeight = StandingHeight.new(_size)


func _init() -> void:
	var back: ColorRect = ColorRect.new()
	back.color = Color(0.09, 0.1, 0.12)
	back.set_anchors_preset(Control.PRESET_FULL_RECT)
	add_child(back)
	_picture.anchor_right = 0.45
	_picture.anchor_bottom = 1.0
	add_child(_picture)
	_picture.stage.add_child(_figure)
	for label: Label in [_stage, _seconds, _words]:
		label.vertical_alignment = VERTICAL_ALIGNMENT_CENTER
		add_child(label)
	resized.connect(_fit)
	mouse_filter = Control.MOUSE_FILTER_STOP
	visible = false


func _ready() -> void:
	_fit()


## Shows a calibration that runs, or its result; hides itself while there is none.
func show_process(p_process: CalibrationProcess) -> void:
	visible = p_process.phase != CalibrationProcess.Phase.IDLE
	if p_process.is_running():
		_show_step(p_process)
	elif visible:
		_show_result(p_process.result)


## The words that are shown, for those who look for them.
func text() -> String:
	return "%s %s\n%s" % [_stage.text, _seconds.text, _words.text]


func _show_step(p_process: CalibrationProcess) -> void:
	_stage.text = _STAGES[p_process.phase]
	_stage.modulate = _COLORS[p_process.phase]
	_seconds.text = str(ceili(p_process.seconds_left))
	_seconds.modulate = _COLORS[p_process.phase]
	_say(p_process.instruction())
	var pose: PoseSample = p_process.current_step().pose_at(p_process.step_part())
	_show_figure(pose, PackedInt32Array())


func _show_result(p_result: CalibrationResult) -> void:
	var is_check: bool = p_result.calibration == null and p_result.error == ""
	var trouble: PackedInt32Array = []
	for place: CalibrationResult.PlaceQuality in p_result.mounts:
		if not ["good", "fair"].has(place.grade()):
			trouble.append(BodyMounts.LIMBS[place.mount])
	var pose: PoseSample = CalibrationGuide.countdown(ResetPose.Kind.N).pose_at(0.0)
	_show_figure(pose, trouble)
	if p_result.error != "":
		_stage.text = "It did not work"
		_seconds.text = "–"
		_stage.modulate = _RESULTS["poor"]
	elif is_check:
		_stage.text = "Sensors elsewhere" if p_result.is_reassigned() else "All sensors are right"
		_seconds.text = str(p_result.exchanges().size()) if p_result.is_reassigned() else "✓"
		_stage.modulate = _RESULTS["poor" if p_result.is_reassigned() else "good"]
	else:
		_stage.text = p_result.word().capitalize()
		_seconds.text = "%d°" % roundi(p_result.error_deg)
		_stage.modulate = _RESULTS[p_result.word()]
	_seconds.modulate = _stage.modulate
	var lines: PackedStringArray = []
	if p_result.error != "":
		lines.append(p_result.error)
	lines.append_array(p_result.advice.slice(0, 2))
	if ends != "":
		lines.append(ends)
	elif p_result.error == "" and not is_check:
		lines.append(InputKeys.label("Accept", &"accept_calibration"))
	if ends == "":
		lines.append(InputKeys.label("Again", &"repeat_calibration") + "   Esc: drop it")
	_say("\n".join(lines))


## Shows the figure with its feet on the floor.
func _show_figure(p_pose: PoseSample, p_trouble: PackedInt32Array) -> void:
	p_pose.root = Vector3(0.0, _standing.of(p_pose), 0.0)
	_figure.show_pose(p_pose, _size, p_trouble)


## Sizes of letters follow the view's.
func _fit() -> void:
	_stage.add_theme_font_size_override(&"font_size", maxi(roundi(size.y * _WORDS * 1.3), 8))
	_seconds.add_theme_font_size_override(&"font_size", maxi(roundi(size.y * _SECONDS), 8))
	_fit_words()


func _say(p_text: String) -> void:
	if _words.text != p_text:
		_words.text = p_text
		_fit_words()


## Makes the words as large as they fit.
func _fit_words() -> void:
	var room: Vector2 = size * Vector2(0.52, 0.41)
	var font: Font = _words.get_theme_font(&"font")
	var letters: int = maxi(roundi(size.y * _WORDS), 8)
	while letters > size.y * _SMALLEST:
		var needed: Vector2 = font.get_multiline_string_size(
			_words.text, HORIZONTAL_ALIGNMENT_LEFT, room.x, letters
		)
		# Between lines there is more than the font's own height.
		if needed.y * 1.12 < room.y:
			break
		letters -= 2
	_words.add_theme_font_size_override(&"font_size", letters)
