class_name InstrumentPanel
extends Control
## The instruments of a vehicle: speed, revolutions, gear, where the turret points, what is broken.

const _BACK: Color = Color(0.03, 0.035, 0.04, 0.62)
const _TEXT: Color = Color(0.9, 0.92, 0.88)
const _DIM: Color = Color(0.55, 0.6, 0.56)
const _WARN: Color = Color(1.0, 0.55, 0.2)
const _HULL: Color = Color(0.6, 0.64, 0.55)
const _DAMAGE: Array[String] = ["", "DAMAGED", "KNOCKED OUT"]
## Full scale of the rev counter where the engine is unknown, 1/min.
const _MAX_RPM: float = 2800.0
const _PAD: float = 14.0

## The engine's greatest speed, 1/min.
var most_rpm: float = _MAX_RPM

## The gun whose rounds are shown; null: none.
var gun: VehicleGun = null

var _state: VehicleState = null
var _selector: VehicleInput.Selector = VehicleInput.Selector.AUTOMATIC


func _draw() -> void:
	if _state == null:
		return
	draw_style_box(_make_box(), Rect2(Vector2.ZERO, size))
	var font: Font = get_theme_default_font()
	var speed: float = absf(_state.left_speed + _state.right_speed) * 0.5 * 3.6
	_write(font, Vector2(_PAD, 44.0), "%d" % roundi(speed), 36, _TEXT)
	_write(font, Vector2(_PAD + 68.0, 44.0), "km/h", 15, _DIM)
	_write(font, Vector2(_PAD, 70.0), describe_gear(_state, _selector), 17, _TEXT)
	_draw_revolutions(font)
	_draw_rose(Vector2(size.x - 44.0, 46.0), 32.0)
	if is_instance_valid(gun):
		var colour: Color = _TEXT if gun.loaded >= 1.0 else _WARN
		_write(font, Vector2(_PAD + 64.0, 108.0), describe_gun(gun), 13, colour)
	var words: String = describe_condition(_state)
	if words != "":
		var colour: Color = _WARN if _state.damage > 0 or not _state.engine_on else _DIM
		_write(font, Vector2(_PAD, size.y - 10.0), words, 14, colour)


## Shows a vehicle's state and the gear that the driver has chosen.
func show_state(p_state: VehicleState, p_selector: VehicleInput.Selector) -> void:
	_state = p_state
	_selector = p_selector
	queue_redraw()


## The gear, for people: A3, R1, N.
static func describe_gear(p_state: VehicleState, p_selector: VehicleInput.Selector) -> String:
	var chosen: String = ["A", "F", "N", "R"][p_selector]
	if p_state.gear == 0:
		return "Gear N" if chosen == "N" else "Gear %s -" % chosen
	if p_state.gear < 0:
		return "Gear R%d" % -p_state.gear
	return "Gear %s%d" % [chosen, p_state.gear]


## What is in a gun and how many rounds are left, for people.
static func describe_gun(p_gun: VehicleGun) -> String:
	var kind: Ammunition = p_gun.ammunition[p_gun.chosen]
	if p_gun.loaded < 1.0:
		return "%s %d %%" % [kind.title, floori(p_gun.loaded * 100.0)]
	return "%s  %d" % [kind.title, p_gun.rounds()]


## What else a crew should know, for people.
static func describe_condition(p_state: VehicleState) -> String:
	var words: PackedStringArray = []
	if p_state.damage > 0:
		words.append(_DAMAGE[p_state.damage])
	if not p_state.engine_on:
		words.append("engine off")
	if not p_state.stabilised:
		words.append("stabiliser off")
	if p_state.lamps:
		words.append("lamps")
	if p_state.hatch > 0.5:
		words.append("hatch open")
	if p_state.brake > 0.1:
		words.append("brake")
	return "  ".join(words)


func _draw_revolutions(p_font: Font) -> void:
	var bar: Rect2 = Rect2(_PAD, 82.0, size.x - 2.0 * _PAD, 8.0)
	draw_rect(bar, Color(1.0, 1.0, 1.0, 0.12))
	var share: float = clampf(_state.rpm / most_rpm, 0.0, 1.0)
	bar.size.x *= share
	draw_rect(bar, _WARN if share > 0.95 else _HULL)
	_write(p_font, Vector2(_PAD, 108.0), "%d /min" % roundi(_state.rpm), 13, _DIM)


## The hull from above, and where the turret points.
func _draw_rose(p_middle: Vector2, p_radius: float) -> void:
	draw_arc(p_middle, p_radius, 0.0, TAU, 40, Color(1.0, 1.0, 1.0, 0.25), 1.5, true)
	var half: Vector2 = Vector2(p_radius * 0.42, p_radius * 0.72)
	draw_rect(Rect2(p_middle - half, 2.0 * half), _HULL, false, 2.0)
	var way: Vector2 = Vector2.UP.rotated(-_state.turret_yaw)
	draw_line(p_middle, p_middle + way * p_radius * 1.1, _WARN, 3.0, true)
	draw_circle(p_middle, p_radius * 0.24, _HULL)


func _write(p_font: Font, p_at: Vector2, p_text: String, p_size: int, p_colour: Color) -> void:
	draw_string(p_font, p_at, p_text, HORIZONTAL_ALIGNMENT_LEFT, -1.0, p_size, p_colour)


static func _make_box() -> StyleBoxFlat:
	var box: StyleBoxFlat = StyleBoxFlat.new()
	box.bg_color = _BACK
	box.set_corner_radius_all(6)
	return box
