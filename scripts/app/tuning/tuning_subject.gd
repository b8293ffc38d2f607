class_name TuningSubject
extends Node3D
## The person that is tuned: a ragdoll that plays a clip, what hits it, and its settings.
##
## The settings outlive [method reset], which makes the ragdoll anew.

## The ragdoll has been made again; its motor has the settings.
signal began
## A tick has been measured: for each limb of the profile its error (degrees), its joint's torque
## (N m) and that torque as a share of the greatest (1 is at the limit).
signal measured(
	errors_deg: PackedFloat32Array, torques_nm: PackedFloat32Array, saturations: PackedFloat32Array
)

const _BALL_MASS_KG: float = 5.0
const _BALL_RADIUS_M: float = 0.12
const _BALL_SPEED: float = 10.0
const _BALL_FROM_M: float = 3.0
const _CRATE_HEIGHT_M: float = 1.0
## Maximum of things; beyond it the oldest is removed.
const _MAX_THINGS: int = 20

## The person, a [Ragdoll].
@export var person: PackedScene = null
## What [method drop_crate] drops.
@export var crate: PackedScene = null

## The ragdoll; null only where it could not start.
var ragdoll: Ragdoll = null
## Seconds that were played.
var time_s: float = 0.0
## Whether the sample that follows the tick is known already, as with a buffer of one tick.
var has_buffer: bool = false
## How often the guard acted, by flag.
var guard_counts: Dictionary[int, int] = {}

var _source: BvhSource = null
## Settings of each strength group: mode, strength, frequency and damping ratio.
var _modes: Dictionary[StringName, RagdollMotor.Actuation] = {}
var _strengths: Dictionary[StringName, float] = {}
var _springs: Dictionary[StringName, Vector2] = {}
## Settings of the motor, by the name of the property.
var _numbers: Dictionary[StringName, float] = {}
var _root_mode: RagdollMotor.RootMode = RagdollMotor.ROOT_SOFT
var _knows_root_mode: bool = false
var _things: Array[RigidBody3D] = []


func _physics_process(p_delta: float) -> void:
	if ragdoll == null:
		return
	if time_s > 0.0:
		ragdoll.motor.measure(time_s)
	var at: float = time_s + (p_delta if has_buffer else 0.0)
	var sample: PoseSample = _sample(at)
	ragdoll.push_sample(at, sample, sample.root)
	ragdoll.drive(time_s, p_delta)
	time_s += p_delta
	var errors: PackedFloat32Array = ragdoll.motor.get_limb_errors()
	for i: int in errors.size():
		errors[i] = rad_to_deg(errors[i])
	measured.emit(errors, ragdoll.motor.get_limb_torques(), ragdoll.motor.get_limb_saturations())


## Plays a BVH file from its beginning. If it cannot, the person stands in the reset pose; returns
## why, or an empty text.
func play(p_file: String) -> String:
	var source: BvhSource = BvhSource.new()
	source.open(p_file)
	_source = source if source.error == "" else null
	reset()
	return source.error


## Makes the person again, at the beginning of the clip, and removes what was thrown.
func reset() -> void:
	for thing: RigidBody3D in _things:
		thing.queue_free()
	_things.clear()
	if ragdoll != null:
		remove_child(ragdoll)
		ragdoll.queue_free()
	time_s = 0.0
	guard_counts.clear()
	ragdoll = person.instantiate()
	add_child(ragdoll)
	if not ragdoll.start():
		ragdoll.queue_free()
		ragdoll = null
		return
	ragdoll.motor.measures_torque = true
	ragdoll.motor.measures_lag = true
	ragdoll.motor.guard_acted.connect(_on_guard_acted)
	_apply()
	began.emit()


## Names of the strength groups.
func groups() -> PackedStringArray:
	return ragdoll.profile.get_groups() if ragdoll != null else PackedStringArray()


## What is played, for people.
func describe() -> String:
	return _source.describe() if _source != null else "the reset pose"


## How a group is driven, all with an empty name; see [method RagdollMotor.set_actuation].
func set_actuation(p_mode: RagdollMotor.Actuation, p_group: StringName, p_blend_s: float) -> void:
	for group: StringName in _chosen(p_group):
		_modes[group] = p_mode
	if ragdoll != null:
		ragdoll.motor.set_actuation(p_mode, p_group, p_blend_s)
		_measure_anew()


## See [method RagdollMotor.set_group_strength].
func set_strength(p_strength: float, p_group: StringName, p_blend_s: float) -> void:
	for group: StringName in _chosen(p_group):
		_strengths[group] = p_strength
	if ragdoll != null:
		ragdoll.motor.set_group_strength(p_strength, p_group, p_blend_s)
		_measure_anew()


## See [method RagdollMotor.set_group_spring]: x is the frequency (Hz), y the damping ratio.
func set_spring(p_spring: Vector2, p_group: StringName) -> void:
	for group: StringName in _chosen(p_group):
		_springs[group] = p_spring
	if ragdoll != null:
		ragdoll.motor.set_group_spring(p_spring.x, p_spring.y, p_group)
		_measure_anew()


## The spring of a group, or of the first one: frequency (Hz) and damping ratio, 0 for the mode's.
func get_spring(p_group: StringName) -> Vector2:
	var chosen: Array[StringName] = _chosen(p_group)
	return _springs.get(chosen[0], Vector2.ZERO) if not chosen.is_empty() else Vector2.ZERO


## Sets the motor's [code]gain[/code], [code]muscle_speed[/code], [code]root_force[/code] or
## [code]root_torque[/code].
func set_number(p_property: StringName, p_value: float) -> void:
	_numbers[p_property] = p_value
	if ragdoll != null:
		ragdoll.motor.set(p_property, p_value)
		_measure_anew()


## See [member RagdollMotor.root_mode].
func set_root_mode(p_mode: RagdollMotor.RootMode) -> void:
	_root_mode = p_mode
	_knows_root_mode = true
	if ragdoll != null:
		ragdoll.motor.root_mode = p_mode
		_measure_anew()


## Where the hips are, in the world, m.
func hips() -> Vector3:
	return _limb_position(&"Hips")


## Throws a ball at the chest, from the side of [param p_from] (horizontal, world).
func throw_ball(p_from: Vector3) -> RigidBody3D:
	var ball: RigidBody3D = _make_ball()
	var chest: Vector3 = _limb_position(&"Chest")
	var flat: Vector3 = Vector3(p_from.x, 0.0, p_from.z).normalized()
	var from: Vector3 = chest + (flat if flat != Vector3.ZERO else Vector3.BACK) * _BALL_FROM_M
	# As high as it falls in flight.
	var gravity: float = ProjectSettings.get_setting("physics/3d/default_gravity")
	var fall: float = 0.5 * gravity * pow(_BALL_FROM_M / _BALL_SPEED, 2.0)
	var aim: Vector3 = (chest + Vector3.UP * fall - from).normalized()
	_add_thing(ball, from)
	ball.linear_velocity = aim * _BALL_SPEED
	return ball


## Lets a crate fall onto the person, from 1 m above the head.
func drop_crate() -> RigidBody3D:
	var dropped: RigidBody3D = crate.instantiate()
	_add_thing(dropped, _limb_position(&"Head") + Vector3.UP * _CRATE_HEIGHT_M)
	return dropped


func _sample(p_time_s: float) -> PoseSample:
	var sample: PoseSample = PoseSample.new()
	var hip_height: float = ragdoll.get_hip_height()
	if _source == null:
		for limb: int in Limbs.COUNT:
			sample.set_orientation(limb, Quaternion.IDENTITY)
		sample.root = Vector3(0.0, hip_height, 0.0)
		return sample
	sample = _source.pose_at(p_time_s)
	var begin: Vector3 = _source.pose_at(0.0).root
	var travelled: Vector3 = sample.root - Vector3(begin.x, 0.0, begin.z)
	sample.root = travelled * hip_height / _source.get_hip_height()
	return sample


func _apply() -> void:
	var motor: RagdollMotor = ragdoll.motor
	if _knows_root_mode:
		motor.root_mode = _root_mode
	for property: StringName in _numbers:
		motor.set(property, _numbers[property])
	for group: StringName in _modes:
		motor.set_actuation(_modes[group], group)
	for group: StringName in _strengths:
		motor.set_group_strength(_strengths[group], group)
	for group: StringName in _springs:
		motor.set_group_spring(_springs[group].x, _springs[group].y, group)


## What was measured before a change says nothing about what comes after it.
func _measure_anew() -> void:
	ragdoll.motor.clear_tracking()


func _chosen(p_group: StringName) -> Array[StringName]:
	if p_group != &"":
		return [p_group]
	var all: Array[StringName] = []
	for group: String in groups():
		all.append(StringName(group))
	return all


func _limb_position(p_bone: StringName) -> Vector3:
	if ragdoll == null:
		return Vector3(0.0, 1.0, 0.0)
	var index: int = ragdoll.profile.limbs.find(ragdoll.profile.find(p_bone))
	var body: Transform3D = PhysicsServer3D.body_get_state(
		ragdoll.get_bodies()[index], PhysicsServer3D.BODY_STATE_TRANSFORM
	)
	return body.origin


func _make_ball() -> RigidBody3D:
	var ball: RigidBody3D = RigidBody3D.new()
	ball.mass = _BALL_MASS_KG
	ball.collision_layer = PhysicsLayers.PROPS
	ball.collision_mask = PhysicsLayers.ALL
	ball.continuous_cd = true
	var shape: CollisionShape3D = CollisionShape3D.new()
	var sphere: SphereShape3D = SphereShape3D.new()
	sphere.radius = _BALL_RADIUS_M
	shape.shape = sphere
	ball.add_child(shape)
	var shown: MeshInstance3D = MeshInstance3D.new()
	var mesh: SphereMesh = SphereMesh.new()
	mesh.radius = _BALL_RADIUS_M
	mesh.height = 2.0 * _BALL_RADIUS_M
	var material: StandardMaterial3D = StandardMaterial3D.new()
	material.albedo_color = Color(0.9, 0.45, 0.1)
	mesh.material = material
	shown.mesh = mesh
	ball.add_child(shown)
	return ball


func _add_thing(p_thing: RigidBody3D, p_position: Vector3) -> void:
	if _things.size() >= _MAX_THINGS:
		_things[0].queue_free()
		_things.remove_at(0)
	p_thing.position = p_position
	add_child(p_thing)
	_things.append(p_thing)


func _on_guard_acted(p_actions: int) -> void:
	for flag: int in [
		RagdollMotor.GUARD_ENERGY,
		RagdollMotor.GUARD_SPEED,
		RagdollMotor.GUARD_GAP,
		RagdollMotor.GUARD_LOST,
	]:
		if p_actions & flag != 0:
			guard_counts[flag] = guard_counts.get(flag, 0) + 1
