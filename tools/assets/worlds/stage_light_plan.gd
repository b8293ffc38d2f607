extends RefCounted
## The lights of the stage: see stage_plan.gd.

const WARM: Color = Color(1.0, 0.90, 0.76)
const MAGENTA: Color = Color(1.0, 0.16, 0.55)
const CYAN: Color = Color(0.16, 0.72, 1.0)
const VIOLET: Color = Color(0.48, 0.22, 1.0)
const AMBER: Color = Color(1.0, 0.58, 0.18)

var _put: Callable = Callable()


## Puts each by a callable: [code]func(node: Node3D, place: Transform3D) -> void[/code].
func _init(p_put: Callable) -> void:
	_put = p_put


## The lights of the show, on trusses so high, over a podium of a height, m.
func hang(p_high: float, p_podium: float) -> void:
	var low: float = p_high - 0.5
	# Two follow spots from the front, one of which throws shadows; colours from the sides, rims from
	# behind, a wash on the backdrop.
	var middle: Vector3 = Vector3(0.0, p_podium + 1.0, -9.6)
	var key: StageLight = _light(Vector3(-3.4, low, 0.5), middle, WARM, 4.0)
	key.has_shadow = true
	key.angle = 15.0
	key.reach = 17.0
	key.beam = 0.8
	var fill: StageLight = _light(Vector3(4.2, low, 0.5), middle, Color(0.86, 0.9, 1.0), 1.4)
	fill.angle = 17.0
	fill.reach = 17.0
	fill.beam = 0.5
	for side: float in [-1.0, 1.0]:
		var tint: Color = MAGENTA if side < 0.0 else CYAN
		var across: StageLight = _light(
			Vector3(side * 5.4, low, -9.1), Vector3(side * 0.4, p_podium, -9.9), tint, 3.6
		)
		across.angle = 20.0
		across.reach = 11.0
		across.beam = 1.3
		var rim: StageLight = _light(
			Vector3(side * 2.5, low, -12.8),
			Vector3(side * 1.4, p_podium, -8.4),
			VIOLET if side < 0.0 else AMBER,
			3.6
		)
		rim.angle = 17.0
		rim.reach = 10.0
		rim.beam = 1.2
	var wash: StageLight = _light(
		Vector3(0.0, low, -9.6), Vector3(0.0, 3.2, -14.3), Color(1.0, 0.9, 0.86), 1.3
	)
	wash.angle = 50.0
	wash.reach = 12.0
	wash.beam = 0.0
	_movers(low)


## Lamps over the audience, which burn at dusk, and at the entrance.
func hang_house(p_high: float) -> void:
	for z: float in [3.5, 8.5, 13.8]:
		for x: float in [-6.5, 0.0, 6.5]:
			_lamp(Vector3(x, p_high + 0.9 - absf(x) * 0.02, z), 3.2)
	for side: float in [-1.0, 1.0]:
		_lamp(Vector3(side * 9.4, 4.6, -10.4), 1.2)


func _light(p_at: Vector3, p_to: Vector3, p_colour: Color, p_strength: float) -> StageLight:
	var light: StageLight = StageLight.new()
	light.colour = p_colour
	light.strength = p_strength
	var away: Vector3 = (p_to - p_at).normalized()
	var up: Vector3 = Vector3.UP if absf(away.y) < 0.98 else Vector3.FORWARD
	_put.call(light, Transform3D(Basis.looking_at(away, up), p_at))
	return light


## Beams over the heads of the audience, which light nothing.
func _movers(p_low: float) -> void:
	var tints: Array[Color] = [CYAN, VIOLET, MAGENTA, MAGENTA, VIOLET, CYAN]
	for number: int in 6:
		var x: float = lerpf(-6.6, 6.6, number / 5.0)
		var to: Vector3 = Vector3(x * 1.9, 1.5, 5.5 - absf(x) * 0.3)
		var beam: StageLight = _light(Vector3(x, p_low, -5.55), to, tints[number], 1.0)
		beam.is_lighting = false
		beam.angle = 4.0
		beam.reach = 13.0
		beam.beam = 1.4
		beam.swing = 16.0
		beam.period = 11.0 + number


func _lamp(p_at: Vector3, p_strength: float) -> void:
	var lamp: CeilingLamp = CeilingLamp.new()
	lamp.strength = p_strength
	lamp.drop = 0.9
	lamp.colour = Color(1.0, 0.93, 0.85)
	_put.call(lamp, Transform3D(Basis.IDENTITY, p_at))
