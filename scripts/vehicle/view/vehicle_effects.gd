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
## Velocity of the vehicle as its positions tell it, in the world, m/s.
var velocity: Vector3 = Vector3.ZERO

var _view: VehicleView = null
var _last: Vector3 = Vector3.INF
var _acceleration: Vector3 = Vector3.ZERO
var _is_near: bool = true


## Adds all to a view whose wheels are known.
func configure(p_view: VehicleView, p_width: float, p_pitch: float) -> void:
	_view = p_view
	var count: int = p_view.ground.lifts.size() / 2
	for side: int in 2:
		var one: DustView = DustView.new()
		one.share = p_view.dust_share
		one.configure(p_view, side * count, count)
		dust.append(one)
	for name: String in ["ExhaustLeft", "ExhaustRight"]:
		var exhaust: Node3D = p_view.find_part(name)
		if exhaust != null:
			fumes.add(exhaust)
	marks.configure(p_view, p_width, p_pitch)
	antennas.configure(p_view.model)
	lamps.configure(p_view.model)
	var fire: Node3D = p_view.fire_spot
	damage.configure(p_view.model, fire if fire != null else p_view.model)


## Moves everything on by a time, s, for an eye at a distance, m.
func advance(p_delta: float, p_away: float) -> void:
	_measure(p_delta)
	var state: VehicleState = _view.state
	lamps.advance(state)
	damage.advance(state.damage, p_delta)
	marks.advance(p_delta)
	_is_near = p_away < _AWAY_M
	if not _is_near:
		fumes.stop()
		for one: DustView in dust:
			one.stop()
		return
	var turned: float = state.turret_yaw
	var local: Vector3 = _view.global_basis.inverse() * _acceleration
	antennas.advance(local.rotated(Vector3.UP, -turned), p_delta)
	fumes.advance(state, _view.most_rpm, p_delta)
	_advance_ground(state, p_delta)


func _advance_ground(p_state: VehicleState, p_delta: float) -> void:
	var ahead: float = -velocity.dot(_view.global_basis.z)
	var where: Transform3D = _view.global_transform
	for side: int in 2:
		var speed: float = p_state.left_speed if side == 0 else p_state.right_speed
		dust[side].advance(_view.ground, where, speed, ahead, p_delta)
		_press(side, speed)


## A print where the last wheel leaves the ground.
func _press(p_side: int, p_speed: float) -> void:
	if absf(p_speed) < 0.05:
		return
	var count: int = _view.ground.lifts.size() / 2
	var wheel: int = p_side * count + (0 if p_speed > 0.0 else count - 1)
	var depth: float = 0.0
	if _view.ground.touching[wheel] == 1:
		depth = ContactMaterial.named(dust[p_side].surface).print_depth
	marks.press(
		p_side, _view.ground.points[wheel], _view.global_basis.y, _view.way_of(p_side), depth
	)


func _measure(p_delta: float) -> void:
	var place: Vector3 = _view.global_position
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
