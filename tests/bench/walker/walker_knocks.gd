extends RefCounted
## Knocks walkers over: by a shove at the chest, the blast of a shell that bursts near, or a body of
## a truck's weight that drives into them.

const WalkerCourse: GDScript = preload("res://tests/bench/walker/walker_course.gd")
const WalkerBody: GDScript = preload("res://tests/bench/walker/walker_body.gd")
const SHELL: Ammunition = preload("res://scenes/combat/ammunition/heat_120.tres")
const SHOVES: String = "shoves of 160 N s"
const BLASTS: String = "blasts at 2 to 5 m"
const TRUCK: String = "truck at 3 m/s"
const KINDS: Array[String] = [SHOVES, BLASTS, TRUCK]
const SHOVE_NS: float = 160.0
const TRUCK_KG: float = 3000.0
const TRUCK_SPEED: float = 3.0
## For how long the truck pushes, ticks.
const DRIVES_TICKS: int = 75
const TICK_S: float = 1.0 / 60.0
## When the knock comes, and how long anybody is watched, ticks.
const KNOCK_TICK: int = 150
const WATCHED_TICKS: int = 900
## How long somebody walks again, ticks, and how far that must be, m.
const AGAIN_TICKS: int = 150
const AGAIN_M: float = 1.0

## Who has fallen, and who has walked again.
var fallen: int = 0
var back: int = 0
## How long those who fell took to stand again, s.
var times: Statistics = Statistics.new()

var _course: WalkerCourse = null
var _chance: RandomNumberGenerator = RandomNumberGenerator.new()
var _truck: RigidBody3D = null


func _init(p_course: WalkerCourse, p_seed: int) -> void:
	_course = p_course
	_chance.seed = p_seed


## Knocks somebody who stands, walks or runs, by turns.
func knock(p_kind: String, p_number: int) -> void:
	var body: WalkerBody = WalkerBody.new(_course.view, WalkerCourse.OPEN)
	var way: Vector3 = Vector3.BACK.rotated(Vector3.UP, _chance.randf() * TAU)
	var up_s: float = await _watch(body, p_kind, [0.0, 1.5, 3.0][p_number % 3], way)
	if body.down_ticks > 0:
		fallen += 1
		times.add(up_s)
		back += int(await _walks_again(body))
	body.free_all()
	await _course.view.get_tree().process_frame


func _watch(p_body: WalkerBody, p_kind: String, p_speed: float, p_way: Vector3) -> float:
	var down: int = -1
	var up: int = -1
	for tick: int in WATCHED_TICKS:
		await _course.view.get_tree().physics_frame
		if tick == KNOCK_TICK:
			_begin(p_body, p_kind, p_way)
		_drive(p_way, tick)
		_go(p_body, p_speed if tick > 60 and tick < KNOCK_TICK else 0.0)
		var is_down: bool = p_body.walker.mover.get_mode() == WalkerMover.BODY
		if is_down and down < 0:
			down = tick
		if not is_down and _truck == null and (down >= 0 or tick > 2 * KNOCK_TICK):
			up = tick
			break
	_leave()
	return maxf(up - down, 0) * TICK_S if up >= 0 else INF


func _begin(p_body: WalkerBody, p_kind: String, p_way: Vector3) -> void:
	var hips: Vector3 = p_body.person.hips()
	match p_kind:
		SHOVES:
			var chest: RID = p_body.person.ragdoll.get_bodies()[Limbs.CHEST]
			PhysicsServer3D.body_apply_central_impulse(chest, p_way * SHOVE_NS)
		BLASTS:
			var place: Vector3 = hips - p_way * _chance.randf_range(2.0, 5.0)
			place.y = 0.3
			ShellHits.burst(_course.view.find_world_3d().direct_space_state, place, SHELL)
		TRUCK:
			_truck = RigidBody3D.new()
			_truck.mass = TRUCK_KG
			_truck.gravity_scale = 0.0
			_truck.collision_layer = PhysicsLayers.PROPS
			_truck.collision_mask = PhysicsLayers.PEOPLE
			_truck.axis_lock_linear_y = true
			_truck.axis_lock_angular_x = true
			_truck.axis_lock_angular_y = true
			_truck.axis_lock_angular_z = true
			_truck.add_child(BenchBodies.box(Vector3(2.0, 1.6, 4.0)))
			var at: Vector3 = Vector3(hips.x, 1.1, hips.z) - p_way * 3.0
			_truck.transform = Transform3D(Basis.looking_at(p_way), at)
			_course.view.add_child(_truck)


func _drive(p_way: Vector3, p_tick: int) -> void:
	if _truck == null:
		return
	_truck.linear_velocity = p_way * TRUCK_SPEED
	if p_tick > KNOCK_TICK + DRIVES_TICKS:
		_leave()


func _leave() -> void:
	if _truck != null:
		_truck.queue_free()
		_truck = null


func _walks_again(p_body: WalkerBody) -> bool:
	var from: Vector3 = p_body.person.hips()
	for tick: int in AGAIN_TICKS:
		await _course.view.get_tree().physics_frame
		_go(p_body, 1.5)
	return p_body.person.hips().distance_to(from) > AGAIN_M


static func _go(p_body: WalkerBody, p_speed: float) -> void:
	var input: WalkerInput = WalkerInput.new()
	input.wish.y = p_speed
	p_body.advance(input)
