@icon("res://scenes/vehicle/icons/platform_output.svg")
class_name PlatformOutput
extends Node
## Sends a motion platform the motion of a seat in the world.
##
## It reads the seat's transform once a frame or tick and hands it to a [PlatformSender], whose
## thread does the rest: nothing here waits. A seat that is freed or null counts as silence: the
## platform goes to neutral, as it does while the tree is paused.

## When the seat is looked at.
enum Source {
	## In every frame: for seats that a client shows, which move in frames.
	FRAMES,
	## In every tick of the physics: for bodies that are simulated here.
	PHYSICS,
}

## What moves: its origin is the seat's reference point, its -Z looks ahead.
@export var seat: Node3D = null:
	set(p_value):
		if p_value == seat:
			return
		seat = p_value
		if _sender.is_open():
			_sender.teleport()
		update_configuration_warnings()
## When it moves.
@export var source: Source = Source.FRAMES
## What the platform can do; null: [code]small_hexapod[/code].
@export var platform: MotionPlatform = null
## How its motion is filtered; null: the defaults.
@export var washout: WashoutParameters = null
## Datagrams a second.
@export_range(100, 250, 1, "suffix:Hz") var rate: int = 200

var _sender: PlatformSender = PlatformSender.new()
var _is_paused: bool = false


func _init() -> void:
	# A pause must be noticed; and what moves the seat has done so by then.
	process_mode = Node.PROCESS_MODE_ALWAYS
	process_priority = 1000
	process_physics_priority = 1000


func _get_configuration_warnings() -> PackedStringArray:
	if seat == null:
		return ["It needs the seat whose motion it sends: choose a Node3D in the inspector."]
	return []


func _process(_delta: float) -> void:
	if not _sender.is_open():
		return
	if get_tree().paused != _is_paused:
		_is_paused = get_tree().paused
		_sender.set_paused(_is_paused)
	if source == Source.FRAMES:
		_look(Time.get_ticks_usec() * 1e-6, Engine.get_process_frames())


func _physics_process(_delta: float) -> void:
	if _sender.is_open() and source == Source.PHYSICS:
		var ticks: int = Engine.get_physics_frames()
		_look(float(ticks) / Engine.physics_ticks_per_second, ticks)


func _exit_tree() -> void:
	stop()


## Begins to send. Returns what is wrong, or an empty text.
func start(p_address: PlatformAddress) -> String:
	if p_address.error != "":
		return p_address.error
	var limits: MotionPlatform = platform
	if limits == null:
		limits = MotionPlatform.preset("small_hexapod")
	var fault: String = limits.find_fault()
	if fault != "":
		return fault
	var cueing: MotionCueing = MotionCueing.new()
	limits.apply(cueing)
	var filter: WashoutParameters = washout if washout != null else WashoutParameters.new()
	filter.apply(cueing)
	_sender.outsim_id = p_address.outsim_id
	_is_paused = false
	return _sender.open(p_address.host, p_address.port, p_address.format, rate, cueing)


## Ends sending.
func stop() -> void:
	_sender.close()


## The seat was put elsewhere. Jumps of more than 1.5 m are noticed without it.
func teleport() -> void:
	_sender.teleport()


## What sends, for stats and for what is felt now.
func get_sender() -> PlatformSender:
	return _sender


func _look(p_time_s: float, p_tick: int) -> void:
	if not is_instance_valid(seat) or not seat.is_inside_tree():
		return
	var body: RigidBody3D = _moving_body()
	if body == null:
		_sender.push_state(p_time_s, seat.global_transform, p_tick)
		return
	var arm: Vector3 = seat.global_position - body.to_global(body.center_of_mass)
	var velocity: Vector3 = body.linear_velocity + body.angular_velocity.cross(arm)
	_sender.push_moving_state(p_time_s, seat.global_transform, velocity, p_tick)


## The simulated body that carries the seat; null where it is moved by hand, as at a client.
func _moving_body() -> RigidBody3D:
	if source != Source.PHYSICS:
		return null
	var node: Node = seat
	while node != null:
		if node is RigidBody3D:
			var body: RigidBody3D = node
			return null if body.freeze else body
		node = node.get_parent()
	return null
