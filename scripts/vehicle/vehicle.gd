@tool
@icon("res://scenes/vehicle/icons/vehicle.svg")
class_name Vehicle
extends RigidBody3D
## A vehicle that the server simulates: the driver's [member input] becomes forces in the
## drivetrain, the running gear applies them to hull and ground, and [member state] says what came
## of it.
##
## It looks along -Z; its origin is on the ground, in the middle. Where it is frozen (on clients)
## it simulates nothing and has no wheels.

## What the vehicle is.
@export var parameters: VehicleParameters = null:
	set(p_value):
		parameters = p_value
		update_configuration_warnings()
## Whether the engine runs from the start.
@export var starts_running: bool = true

## What the driver does. Write into it at any time.
var input: VehicleInput = VehicleInput.new()
## What the simulation makes of it.
var state: VehicleState = VehicleState.new()
## Why the wheels could not be made, or an empty text.
var fault: String = ""

var _gear_kind: VehicleParameters.GearKind = VehicleParameters.GearKind.SPHERES
var _is_kind_chosen: bool = false
var _drivetrain: VehicleDrivetrain = null
var _gear: RunningGear = null


func _notification(p_what: int) -> void:
	# Not sent for the steps of the physics: somebody has put the hull elsewhere.
	if p_what == NOTIFICATION_TRANSFORM_CHANGED and _gear != null:
		_gear.place()


func _enter_tree() -> void:
	add_to_group(Shells.VEHICLES)


func _physics_process(p_delta: float) -> void:
	if Engine.is_editor_hint():
		return
	if freeze:
		release()
		return
	if _gear == null and not _begin():
		return
	var selector: VehicleDrivetrain.Selector = input.gear as int as VehicleDrivetrain.Selector
	_drivetrain.set_input(input.throttle, input.steer, input.brake, input.handbrake, selector)
	_gear.step(p_delta)
	_tell()


func _exit_tree() -> void:
	release()


func _get_configuration_warnings() -> PackedStringArray:
	if parameters == null:
		return ["It needs parameters: make a VehicleParameters resource in the inspector."]
	var found: String = VehicleCheck.find_fault(parameters, parameters.gear_kind)
	return [] if found == "" else ["Its parameters make no sense: %s." % found]


## The vehicle that a node is or stands below, or null.
static func find_above(p_node: Node) -> Vehicle:
	var node: Node = p_node
	while node != null and not node is Vehicle:
		node = node.get_parent()
	return node as Vehicle


## Chooses another running gear than the parameters name. The vehicle gets new wheels.
func set_gear_kind(p_kind: VehicleParameters.GearKind) -> void:
	_gear_kind = p_kind
	_is_kind_chosen = true
	release()
	fault = ""


## The running gear that it has now, or will get.
func gear_kind() -> VehicleParameters.GearKind:
	return _gear_kind if _is_kind_chosen or parameters == null else parameters.gear_kind


## Takes the wheels away, until the next step makes new ones.
func release() -> void:
	if _gear != null:
		_gear.release()
		_gear = null
		_drivetrain = null


## Starts or stops the engine.
func set_engine_on(p_is_on: bool) -> void:
	state.engine_on = p_is_on
	if _drivetrain != null:
		_drivetrain.set_running(p_is_on)


## The kick of a gun: an impulse (N s) at a point, both in the world. What is not finite does
## nothing.
func apply_recoil(p_impulse: Vector3, p_point: Vector3) -> void:
	if p_impulse.is_finite() and p_point.is_finite():
		apply_impulse(p_impulse, p_point - global_position)


## Puts the vehicle onto its wheels again, where it is and in the direction that it looks to.
func reset_upright() -> void:
	var ahead: Vector3 = -global_basis.z
	# A vehicle that stands on its nose looks where its belly is.
	if Vector2(ahead.x, ahead.z).length() < 0.2:
		ahead = -global_basis.y if ahead.y < 0.0 else global_basis.y
	ahead.y = 0.0
	if ahead.length() < 0.01:
		ahead = Vector3.FORWARD
	var bottom: float = global_position.y
	# The origin is where the ground is when it stands; now it may be the highest point.
	bottom += minf(0.0, 2.0 * centre_height() * global_basis.y.y)
	var at: Vector3 = Vector3(global_position.x, bottom + 0.5, global_position.z)
	teleport(Transform3D(Basis.looking_at(ahead.normalized(), Vector3.UP), at))


## Puts the vehicle at a transform, at rest. Values that are not finite are refused.
func teleport(p_transform: Transform3D) -> void:
	if not p_transform.is_finite():
		return
	global_transform = p_transform
	# The node tells its body later; the wheels must know now.
	PhysicsServer3D.body_set_state(get_rid(), PhysicsServer3D.BODY_STATE_TRANSFORM, p_transform)
	linear_velocity = Vector3.ZERO
	angular_velocity = Vector3.ZERO
	if _gear != null:
		_drivetrain.reset()
		_gear.place()


## Moves the vehicle with its wheels a little (in the world) without stopping it, and changes its
## velocity (m/s) and angular velocity (rad/s): for a prediction that the server corrects.
func shift(p_by: Transform3D, p_velocity: Vector3, p_spin: Vector3) -> void:
	if not (p_by.is_finite() and p_velocity.is_finite() and p_spin.is_finite()):
		return
	for body: RID in own_bodies():
		var state: PhysicsDirectBodyState3D = PhysicsServer3D.body_get_direct_state(body)
		state.transform = (p_by * state.transform).orthonormalized()
		state.linear_velocity = p_by.basis * state.linear_velocity + p_velocity
		if body == get_rid():
			state.angular_velocity += p_spin


## Gives the vehicle a velocity (m/s) and angular velocity (rad/s, both in the world), with wheels
## that roll along.
func set_motion(p_velocity: Vector3, p_spin: Vector3) -> void:
	if not (p_velocity.is_finite() and p_spin.is_finite()):
		return
	linear_velocity = p_velocity
	angular_velocity = p_spin
	var bodies: Array[RID] = wheel_bodies()
	var ahead: float = -p_velocity.dot(global_basis.z)
	for index: int in bodies.size():
		var radius: float = parameters.wheels_of(_gear_kind)[index].radius
		var state: PhysicsDirectBodyState3D = PhysicsServer3D.body_get_direct_state(bodies[index])
		state.linear_velocity = p_velocity + p_spin.cross(state.transform.origin - global_position)
		state.angular_velocity = p_spin - global_basis.x * ahead / radius


## Height of the centre of mass above the ground when the vehicle stands, m.
func centre_height() -> float:
	return parameters.centre_of_mass.y if parameters != null else 0.0


## What wheels and drivetrain do now; empty where it simulates nothing.
func stats() -> VehicleStats:
	return VehicleStats.new() if _gear == null else VehicleStats.read(_gear, _drivetrain)


## Bodies of the wheels, for callers that must not collide with them; empty where wheels are rays.
func wheel_bodies() -> Array[RID]:
	var bodies: Array[RID] = []
	if _gear != null:
		bodies.assign(_gear.get_bodies())
	return bodies


## All its bodies: hull and wheels.
func own_bodies() -> Array[RID]:
	var bodies: Array[RID] = wheel_bodies()
	bodies.append(get_rid())
	return bodies


## Where a wheel is in the vehicle's frame.
func wheel_transform(p_wheel: int) -> Transform3D:
	return Transform3D.IDENTITY if _gear == null else _gear.get_wheel_transform(p_wheel)


func _begin() -> bool:
	if fault != "":
		return false
	fault = "it has no parameters"
	if parameters != null:
		_gear_kind = gear_kind()
		fault = VehicleCheck.find_fault(parameters, _gear_kind)
	if fault != "":
		Log.error("vehicle", "%s stays where it is: %s" % [get_path(), fault])
		return false
	var wheels: Array[VehicleWheel] = parameters.wheels_of(_gear_kind)
	_weigh(wheels)
	_drivetrain = VehicleSetup.make_drivetrain(parameters)
	_drivetrain.set_running(starts_running)
	_gear = VehicleSetup.make_gear(parameters, _gear_kind)
	_gear.collision_layer = collision_layer
	_gear.collision_mask = collision_mask
	var space: RID = get_world_3d().space
	if not _gear.setup(self, get_rid(), space, wheels, _drivetrain):
		fault = "its running gear could not be made"
		_gear = null
		return false
	return true


func _weigh(p_wheels: Array[VehicleWheel]) -> void:
	mass = parameters.mass
	if _gear_kind == VehicleParameters.GearKind.SPHERES:
		for wheel: VehicleWheel in p_wheels:
			mass -= wheel.mass
	center_of_mass_mode = RigidBody3D.CENTER_OF_MASS_MODE_CUSTOM
	center_of_mass = parameters.centre_of_mass
	var squares: Vector3 = parameters.inertia_box * parameters.inertia_box
	inertia = (
		Vector3(squares.y + squares.z, squares.x + squares.z, squares.x + squares.y) * mass / 12.0
	)


func _tell() -> void:
	state.rpm = _drivetrain.get_rpm()
	state.load = _drivetrain.get_load()
	state.gear = _drivetrain.get_gear()
	state.left_speed = _gear.get_left_speed()
	state.right_speed = _gear.get_right_speed()
	state.steer = _drivetrain.get_steer_angle()
	state.brake = _drivetrain.get_brake()
	state.engine_on = _drivetrain.is_running()
