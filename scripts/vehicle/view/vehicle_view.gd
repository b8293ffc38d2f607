class_name VehicleView
extends Node3D
## Shows a vehicle: its model, moved by the vehicle's [member state] and by the transform of its
## body alone. It is a child of the vehicle's body and needs no bytes of its own.
##
## The model looks along -Z, its origin is on the ground in the vehicle's middle.

## Distance from which on a track is a strip and wheels do not follow the ground, m.
const FAR_M: float = 40.0
## The same in tiers of quality that draw little.
const _FAR_LOW_M: float = 12.0
## Ratio of the steering wheel's angle to that of the wheels.
const STEERING_RATIO: float = 12.0

## Node with the model.
@export var model: Node3D = null
## Measures of the tracks; empty for vehicles without.
@export var tracks: TrackLayout = null
## Width of the tyres of vehicles without tracks, m.
@export_range(0.02, 1.0, 0.01, "suffix:m") var tyre_width: float = 0.28
## Most that a wheel goes up (x), and down (y), from rest, m.
@export_custom(PROPERTY_HINT_NONE, "suffix:m") var travel: Vector2 = Vector2(0.16, 0.14)
## Share of a tank's dust that it throws up.
@export_range(0.0, 1.0, 0.01) var dust_share: float = 1.0
## Node at which it burns when it is knocked out; empty: the model's origin.
@export var fire_spot: Node3D = null
## The engine's greatest speed, 1/min.
@export_range(500.0, 9000.0, 50.0, "suffix:1/min") var most_rpm: float = 2600.0

## What is shown. Who simulates or receives the vehicle sets it.
var state: VehicleState = VehicleState.new()
## The tracks: left, right; empty for vehicles without.
var sides: Array[TrackView] = []
## The wheels of vehicles without tracks: left, right.
var wheels: Array[WheelView] = []
## Turret, gun, hatches.
var turret: TurretView = TurretView.new()
## The flaps of the exhausts.
var exhaust: ExhaustView = ExhaustView.new()
## Finds where its wheels stand: left from rear to front, then right.
var ground: GroundProbe = GroundProbe.new()
## Dust, fumes, prints, antennas, lamps, damage.
var effects: VehicleEffects = VehicleEffects.new()

var _far_m: float = FAR_M
var _steering: Node3D = null
var _steering_rest: Basis = Basis.IDENTITY
var _handlebar: Node3D = null
var _is_far: bool = false


func _ready() -> void:
	turret.configure(model)
	exhaust.configure(model, most_rpm)
	ground.travel_m = travel
	effects.dust_share = dust_share
	effects.fire_spot = fire_spot
	effects.most_rpm = most_rpm
	if tracks != null:
		_make_tracks()
		effects.configure(self, model, ground, tracks.width, tracks.pitch)
	else:
		_make_wheels()
		effects.configure(self, model, ground, tyre_width, 0.0)
	add_to_group(Quality.FOLLOWERS)
	follow_quality()


func _process(p_delta: float) -> void:
	var camera: Camera3D = get_viewport().get_camera_3d()
	var away: float = 0.0
	if camera != null:
		away = camera.global_position.distance_to(global_position)
	advance(p_delta, away)


## Moves everything on by a time, s, for an eye at a distance, m.
func advance(p_delta: float, p_away: float) -> void:
	_set_far(p_away > _far_m)
	if _is_far:
		ground.rest()
	elif is_inside_tree():
		ground.advance(get_world_3d().direct_space_state, global_transform, p_delta)
	turret.advance(state, p_delta)
	exhaust.advance(state, p_delta)
	for side: int in sides.size():
		var speed: float = state.left_speed if side == 0 else state.right_speed
		sides[side].advance(speed, p_delta, _lifts_of(side))
	if not wheels.is_empty():
		_advance_wheels(p_delta)
	if is_inside_tree():
		effects.advance(state, [way_of(0), way_of(1)], p_delta, p_away)


## The gun fires: the barrel recoils.
func show_shot() -> void:
	turret.show_shot()


## Shows as much as the tier of quality says: see [Quality].
func follow_quality() -> void:
	_far_m = _FAR_LOW_M if Quality.tier.name == "low" else FAR_M


## How far a side's track or wheels have run (0 left, 1 right), m.
func way_of(p_side: int) -> float:
	return sides[p_side].way if tracks != null else wheels[p_side].way


## A node of the model by name, such as [code]CommanderHatchMiddle[/code]; null without.
func find_part(p_name: String) -> Node3D:
	return model.find_child(p_name, true, false) as Node3D


func _set_far(p_is_far: bool) -> void:
	if p_is_far == _is_far:
		return
	_is_far = p_is_far
	for side: TrackView in sides:
		side.show_strip(p_is_far)


func _lifts_of(p_side: int) -> PackedFloat32Array:
	var count: int = ground.lifts.size() / 2
	return ground.lifts.slice(p_side * count, (p_side + 1) * count)


func _make_tracks() -> void:
	var hull: Node3D = find_part("Hull")
	var feet: PackedVector3Array = []
	for side: int in 2:
		var track: TrackView = TrackView.new()
		track.configure(model, hull, side, tracks)
		sides.append(track)
		feet.append_array(track.feet)
	find_part("TrackLink").queue_free()
	ground.configure(feet, _find_body())


func _make_wheels() -> void:
	var feet: PackedVector3Array = []
	for side: int in 2:
		var side_wheels: WheelView = WheelView.new()
		side_wheels.configure(model, side)
		wheels.append(side_wheels)
		feet.append_array(side_wheels.feet)
	ground.configure(feet, _find_body())
	_handlebar = find_part("Handlebar")
	_steering = find_part("SteeringWheel")
	if _steering != null:
		_steering_rest = _steering.basis


func _advance_wheels(p_delta: float) -> void:
	for side: int in 2:
		var speed: float = state.left_speed if side == 0 else state.right_speed
		wheels[side].advance(speed, p_delta, _lifts_of(side), state.steer)
	if _handlebar != null:
		_handlebar.rotation.y = state.steer
	if _steering != null:
		_steering.basis = _steering_rest * Basis(Vector3.BACK, state.steer * STEERING_RATIO)


func _find_body() -> CollisionObject3D:
	var node: Node = get_parent()
	while node != null and not node is CollisionObject3D:
		node = node.get_parent()
	return node as CollisionObject3D
