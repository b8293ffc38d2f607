class_name VehicleEffects
extends RefCounted
## The effects of a vehicle: dust, fumes, prints in the ground, swaying antennas, lamps, damage.

## Distance from which on there is no dust, no fumes and no new print, m.
const _AWAY_M: float = 150.0
## Time constant with which velocity and acceleration are estimated from positions, s.
const _SPEED_S: float = 0.08
## Greatest plausible acceleration, m/s^2: more is a teleport.
const _MAX_ACCELERATION: float = 25.0

## Dust of the left and the right side.
var dust: Array[DustView] = []
## Fumes from the exhausts.
var fumes: FumesView = FumesView.new()
## Prints in the ground.
var marks: TrackMarks = TrackMarks.new()
## Antennas.
var antennas: AntennaView = AntennaView.new()
## Lamps.
var lamps: LampView = LampView.new()
## Scorched, smoking, burning.
var damage: DamageView = DamageView.new()
## Share of a tank's dust that it throws up.
var dust_share: float = 1.0
## Where it burns when it is knocked out; null: the model's origin.
var fire_spot: Node3D = null
## The engine's greatest speed, 1/min.
var most_rpm: float = 2600.0
## Velocity of the vehicle as its positions tell it, in the world, m/s.
var velocity: Vector3 = Vector3.ZERO

var _body: Node3D = null
var _ground: GroundProbe = null
var _last: Vector3 = Vector3.INF
var _acceleration: Vector3 = Vector3.ZERO
var _is_near: bool = true


## Adds all to a vehicle's body and model, once it is known where its wheels stand.
## [param p_width] is that of its prints and [param p_pitch] the length of a link of its tracks, m;
## 0: it has tyres.
func configure(
	p_body: Node3D, p_model: Node3D, p_ground: GroundProbe, p_width: float, p_pitch: float
) -> void:
	_body = p_body
	_ground = p_ground
	var count: int = p_ground.lifts.size() / 2
	for side: int in 2:
		var one: DustView = DustView.new()
		one.share = dust_share
		one.configure(p_body, side * count, count)
		dust.append(one)
	for name: String in ["ExhaustLeft", "ExhaustRight"]:
		var exhaust: Node3D = p_model.find_child(name, true, false) as Node3D
		if exhaust != null:
			fumes.add(exhaust)
	marks.configure(p_body, p_width, p_pitch)
	antennas.configure(p_model)
	lamps.configure(p_model)
	damage.configure(p_model, fire_spot if fire_spot != null else p_model)


## Moves everything on by a time, s, for an eye at a distance, m. [param p_runs] is how far the left
## and the right track or wheels have run, m.
func advance(
	p_state: VehicleState, p_runs: PackedFloat64Array, p_delta: float, p_away: float
) -> void:
	_measure(p_delta)
	lamps.advance(p_state)
	damage.advance(p_state.damage, p_delta)
	marks.advance(p_delta)
	_is_near = p_away < _AWAY_M
	if not _is_near:
		fumes.stop()
		for one: DustView in dust:
			one.stop()
		return
	var turned: float = p_state.turret_yaw
	var local: Vector3 = _body.global_basis.inverse() * _acceleration
	antennas.advance(local.rotated(Vector3.UP, -turned), p_delta)
	fumes.advance(p_state, most_rpm, p_delta)
	_advance_ground(p_state, p_runs, p_delta)


func _advance_ground(p_state: VehicleState, p_runs: PackedFloat64Array, p_delta: float) -> void:
	var ahead: float = -velocity.dot(_body.global_basis.z)
	var where: Transform3D = _body.global_transform
	for side: int in 2:
		var speed: float = p_state.left_speed if side == 0 else p_state.right_speed
		dust[side].advance(_ground, where, speed, ahead, p_delta)
		_press(side, speed, p_runs[side])


## A print where the last wheel leaves the ground.
func _press(p_side: int, p_speed: float, p_run: float) -> void:
	if absf(p_speed) < 0.05:
		return
	var count: int = _ground.lifts.size() / 2
	var wheel: int = p_side * count + (0 if p_speed > 0.0 else count - 1)
	var depth: float = 0.0
	if _ground.touching[wheel] == 1:
		depth = ContactMaterial.named(dust[p_side].surface).print_depth
	marks.press(p_side, _ground.points[wheel], _body.global_basis.y, p_run, depth)


func _measure(p_delta: float) -> void:
	var place: Vector3 = _body.global_position
	if not _last.is_finite() or p_delta <= 0.0:
		_last = place
		return
	var moved: Vector3 = (place - _last) / p_delta
	_last = place
	var before: Vector3 = velocity
	var share: float = 1.0 - exp(-p_delta / _SPEED_S)
	velocity = velocity.lerp(moved, share)
	var change: Vector3 = ((velocity - before) / p_delta).limit_length(_MAX_ACCELERATION)
	_acceleration = _acceleration.lerp(change, share)
