class_name LimbPlots
extends PanelContainer
## The plots of all limbs, one below the other, under a heading with the units.

const _HEADINGS: Array[String] = ["error, deg", "torque, N m", "saturation, %"]
## A value is kept every so many ticks: the largest of them, so that no peak gets lost.
const _TICKS: int = 2
## Time between two drawings, s.
const _REDRAW_S: float = 0.05

## The plots, in the order of the profile's limbs.
var plots: Array[LimbPlot] = []

var _list: VBoxContainer = VBoxContainer.new()
var _peaks: Array[PackedFloat32Array] = []
var _ticks: int = 0
var _age_s: float = 0.0


func _ready() -> void:
	_list.add_theme_constant_override("separation", 1)
	add_child(_list)


func _process(p_delta: float) -> void:
	_age_s += p_delta
	if _age_s >= _REDRAW_S:
		_age_s = 0.0
		for plot: LimbPlot in plots:
			plot.queue_redraw()


## Makes a plot for each limb of a profile.
func show_limbs(p_profile: RagdollProfile) -> void:
	for child: Node in _list.get_children():
		child.free()
	plots.clear()
	_peaks.clear()
	_ticks = 0
	_list.add_child(_Heading.new())
	for limb: RagdollLimb in p_profile.limbs:
		var plot: LimbPlot = LimbPlot.new()
		plot.title = shorten(limb.bone)
		plot.name = limb.bone
		_list.add_child(plot)
		plots.append(plot)


## Takes what a tick has measured: degrees, N m, shares of the limit; a value for each limb.
func push(
	p_errors_deg: PackedFloat32Array,
	p_torques_nm: PackedFloat32Array,
	p_saturations: PackedFloat32Array
) -> void:
	var arrays: Array[PackedFloat32Array] = [p_errors_deg, p_torques_nm, p_saturations]
	if _ticks == 0:
		_peaks = [p_errors_deg.duplicate(), p_torques_nm.duplicate(), p_saturations.duplicate()]
	for curve: int in arrays.size():
		_peaks[curve].resize(plots.size())
		for limb: int in mini(arrays[curve].size(), plots.size()):
			_peaks[curve][limb] = maxf(_peaks[curve][limb], arrays[curve][limb])
	_ticks += 1
	if _ticks < _TICKS:
		return
	_ticks = 0
	for limb: int in plots.size():
		plots[limb].push(_peaks[0][limb], _peaks[1][limb], _peaks[2][limb] * 100.0)


## A limb's name that fits: "L upper arm" for LeftUpperArm.
static func shorten(p_bone: String) -> String:
	var text: String = p_bone.capitalize()
	text = text.replace("Left ", "L ").replace("Right ", "R ")
	return text.left(1) + text.substr(1).to_lower()


## The headings of the columns.
class _Heading:
	extends Control

	func _init() -> void:
		custom_minimum_size = Vector2(0.0, 18.0)
		mouse_filter = Control.MOUSE_FILTER_IGNORE

	func _draw() -> void:
		var font: Font = get_theme_default_font()
		var span: String = "last %.0f s" % LimbPlot.SPAN_S
		draw_string(font, Vector2(2.0, 13.0), span, HORIZONTAL_ALIGNMENT_LEFT, -1, 13)
		for curve: int in LimbPlot.Trace.size():
			var across: Vector2 = LimbPlot.box(curve as LimbPlot.Trace, size.x)
			var colour: Color = LimbPlot.COLOURS[curve]
			var corner: Vector2 = Vector2(across.x, 13.0)
			draw_string(font, corner, _HEADINGS[curve], HORIZONTAL_ALIGNMENT_LEFT, -1, 13, colour)
