class_name VehicleCourses
extends RefCounted
## What a vehicle can do, each on ground of its own: how fast, how steep, how high.

const KMH: float = 3.6
## A course is given up after so long, s.
const LIMIT_S: float = 60.0
const HZ: float = 60.0

var _tree: SceneTree = null
var _preset: String = ""
var _kind: VehicleParameters.GearKind = VehicleParameters.GearKind.SPHERES
var _ground: VehicleGround = null


func _init(p_tree: SceneTree, p_preset: String, p_kind: VehicleParameters.GearKind) -> void:
	_tree = p_tree
	_preset = p_preset
	_kind = p_kind


## Speed after so long with the pedal down, km/h, and how far it has come off a straight line after
## 300 m, m.
func top_speed() -> Vector2:
	var vehicle: Vehicle = await _begin_on_floor()
	var from: Vector3 = vehicle.position
	vehicle.input.throttle = 1.0
	var time: float = await _until(func() -> bool: return vehicle.position.z < from.z - 300.0)
	var drift: float = absf(vehicle.position.x - from.x)
	await _ground.run(LIMIT_S - minf(time, LIMIT_S))
	var speed: float = VehicleGround.speed_of(vehicle) * KMH
	_end()
	return Vector2(speed, drift)


## Time from standstill to a speed (km/h), s.
func sprint(p_speed: float) -> float:
	var vehicle: Vehicle = await _begin_on_floor()
	vehicle.input.throttle = 1.0
	var time: float = await _until(
		func() -> bool: return VehicleGround.speed_of(vehicle) * KMH >= p_speed
	)
	_end()
	return time


## Way that it takes to stand from a speed (km/h), m.
func brake_from(p_speed: float) -> float:
	var vehicle: Vehicle = await _begin_on_floor()
	vehicle.input.throttle = 1.0
	await _until(func() -> bool: return VehicleGround.speed_of(vehicle) * KMH >= p_speed)
	var from: Vector3 = vehicle.position
	vehicle.input.throttle = 0.0
	vehicle.input.brake = 1.0
	await _until(func() -> bool: return vehicle.linear_velocity.length() < 0.05)
	var way: float = vehicle.position.distance_to(from)
	_end()
	return way


## Time of a whole turn on the spot, s, and how far its middle comes off its place, m.
func turn_on_the_spot() -> Vector2:
	var vehicle: Vehicle = await _begin_on_floor()
	var from: Vector3 = vehicle.position
	vehicle.input.steer = 1.0
	var turned: PackedFloat64Array = [0.0]
	var time: float = await _until(
		func() -> bool:
			turned[0] += vehicle.angular_velocity.y / HZ
			return turned[0] >= TAU
	)
	var away: float = vehicle.position.distance_to(from)
	_end()
	return Vector2(time, away)


## Radius of the circle that it drives at a speed (m/s) with the wheel turned fully, m.
func turning_radius(p_speed: float) -> float:
	var vehicle: Vehicle = await _begin_on_floor()
	vehicle.input.steer = 1.0
	for _tick: int in int(12.0 * HZ):
		var speed: float = VehicleGround.speed_of(vehicle)
		vehicle.input.throttle = clampf(0.1 + p_speed - speed, 0.0, 1.0)
		vehicle.input.brake = clampf(0.3 * (speed - p_speed - 0.2), 0.0, 1.0)
		await _tree.physics_frame
	var rate: float = maxf(absf(vehicle.angular_velocity.y), 1e-3)
	var radius: float = vehicle.linear_velocity.length() / rate
	_end()
	return radius


## Whether it holds on a slope (0.6 is 60 %) without anybody's foot, and then climbs it.
func climbs(p_slope: float) -> bool:
	_ground = VehicleGround.new(_tree.root)
	# It looks along -Z: that must go uphill.
	var slope: StaticBody3D = _ground.add_slope(p_slope, Vector3.RIGHT)
	var vehicle: Vehicle = _ground.add_vehicle(_preset, _kind, _resting(slope.basis))
	await _ground.run(2.0)
	var from: Vector3 = vehicle.position
	await _ground.run(5.0)
	var holds: bool = vehicle.position.distance_to(from) < 0.05
	vehicle.input.throttle = 1.0
	await _ground.run(10.0)
	var speed: float = VehicleGround.speed_of(vehicle)
	var height: float = vehicle.position.y - from.y
	vehicle.input.throttle = 0.0
	vehicle.input.brake = 1.0
	await _ground.run(4.0)
	var stops: bool = vehicle.linear_velocity.length() < 0.1
	_end()
	return holds and stops and speed > 0.5 and height > 2.0


## The steepest slope of a list that it climbs, %.
func steepest(p_slopes: PackedFloat32Array) -> float:
	return await _largest(p_slopes, climbs)


## The steepest slope to the side, %: it stands for 10 s and slips less than 1 m over 40 m.
func steepest_sideways(p_slopes: PackedFloat32Array) -> float:
	return await _largest(p_slopes, goes_along)


## How far it slips down over 40 m along a slope to its side, m; INF if it does not get there.
func slip_along(p_slope: float) -> float:
	_ground = VehicleGround.new(_tree.root)
	var slope: StaticBody3D = _ground.add_slope(p_slope, Vector3.BACK)
	var vehicle: Vehicle = _ground.add_vehicle(_preset, _kind, _resting(slope.basis))
	await _ground.run(3.0)
	var from: Vector3 = vehicle.position
	await _ground.run(10.0)
	var crept: float = vehicle.position.distance_to(from)
	vehicle.input.throttle = 0.4
	await _until(func() -> bool: return vehicle.position.distance_to(from) > 40.0, 30.0)
	var slip: float = absf((vehicle.position - from).dot(slope.basis.x))
	var arrived: bool = vehicle.position.distance_to(from) > 39.0 and vehicle.global_basis.y.y > 0.7
	_end()
	return slip if arrived and crept < 0.1 else INF


## Whether it can be driven along a slope to its side.
func goes_along(p_slope: float) -> bool:
	return await slip_along(p_slope) < 1.0


## Whether it gets up a step, m.
func takes_step(p_height: float) -> bool:
	var vehicle: Vehicle = await _begin_on_floor()
	var size: Vector3 = Vector3(30.0, 10.0, 60.0)
	var at: Vector3 = Vector3(0.0, p_height - 5.0, -38.0)
	_ground.add_box(size, Transform3D(Basis.IDENTITY, at))
	vehicle.input.throttle = 0.35
	await _until(func() -> bool: return vehicle.position.z < -3.0, 10.0)
	vehicle.input.throttle = 1.0
	var time: float = await _until(func() -> bool: return vehicle.position.z < -16.0, 20.0)
	var is_up: bool = (
		is_finite(time) and vehicle.position.y > p_height - 0.3 and vehicle.global_basis.y.y > 0.9
	)
	_end()
	return is_up


## The highest step of a list, m.
func highest_step(p_heights: PackedFloat32Array) -> float:
	return 0.01 * await _largest(p_heights, takes_step)


## Whether it gets over a trench of a width, m.
func crosses(p_width: float) -> bool:
	_ground = VehicleGround.new(_tree.root)
	for side: float in [-1.0, 1.0]:
		var at: Vector3 = Vector3(0.0, -5.0, side * (50.0 + 0.5 * p_width))
		_ground.add_box(Vector3(40.0, 10.0, 100.0), Transform3D(Basis.IDENTITY, at))
	var start: Transform3D = Transform3D(Basis.IDENTITY, Vector3(0.0, 0.05, 12.0))
	var vehicle: Vehicle = _ground.add_vehicle(_preset, _kind, start)
	await _ground.run(1.0)
	for _tick: int in int(25.0 * HZ):
		vehicle.input.throttle = 0.6 if VehicleGround.speed_of(vehicle) < 2.5 else 0.1
		if vehicle.position.z < 4.0 and VehicleGround.speed_of(vehicle) < 1.5:
			vehicle.input.throttle = 1.0
		await _tree.physics_frame
		if vehicle.position.z < -10.0:
			break
	var is_over: bool = vehicle.position.z < -9.0 and vehicle.position.y > -0.3
	_end()
	return is_over


## The widest trench of a list, m.
func widest_trench(p_widths: PackedFloat32Array) -> float:
	return 0.01 * await _largest(p_widths, crosses)


## Ride over bumps of 0.3 m at a speed (m/s): vertical acceleration of the driver (m/s^2 RMS) and
## largest pitch (deg).
func ride(p_speed: float) -> Vector2:
	_ground = VehicleGround.new(_tree.root)
	_ground.view.add_child(VehicleBumps.create())
	var start: Transform3D = Transform3D(Basis.IDENTITY, Vector3(0.0, 0.05, 0.0))
	var vehicle: Vehicle = _ground.add_vehicle(_preset, _kind, start)
	await _ground.run(1.0)
	var sum: float = 0.0
	var count: int = 0
	var pitch: float = 0.0
	var last: float = 0.0
	for tick: int in int(25.0 * HZ):
		var speed: float = VehicleGround.speed_of(vehicle)
		vehicle.input.throttle = clampf(0.3 + 0.5 * (p_speed - speed), 0.0, 1.0)
		# Straight on: the bumps are not to throw it off their course.
		vehicle.input.steer = clampf(
			-3.0 * vehicle.rotation.y - 0.1 * -vehicle.position.x, -0.4, 0.4
		)
		await _tree.physics_frame
		var lever: Vector3 = vehicle.global_basis * Vector3(0.0, 1.5, -2.0)
		var now: float = (vehicle.linear_velocity + vehicle.angular_velocity.cross(lever)).y
		if tick > int(8.0 * HZ):
			sum += (now - last) * (now - last) * HZ * HZ
			count += 1
			pitch = maxf(pitch, absf(rad_to_deg(vehicle.rotation.x)))
		last = now
	_end()
	return Vector2(sqrt(sum / maxf(count, 1.0)), pitch)


func _largest(p_values: PackedFloat32Array, p_can: Callable) -> float:
	var found: float = 0.0
	for value: float in p_values:
		if not await p_can.call(value):
			break
		found = value
	return 100.0 * found


func _resting(p_basis: Basis) -> Transform3D:
	return Transform3D(p_basis, p_basis.y * 0.05)


func _begin_on_floor() -> Vehicle:
	_ground = VehicleGround.new(_tree.root)
	_ground.add_floor()
	var start: Transform3D = Transform3D(Basis.IDENTITY, Vector3(0.0, 0.05, 0.0))
	var vehicle: Vehicle = _ground.add_vehicle(_preset, _kind, start)
	await _ground.run(2.0)
	return vehicle


func _end() -> void:
	_ground.free_all()


## Waits until something holds, and returns for how long; INF if it never does.
func _until(p_holds: Callable, p_limit_s: float = LIMIT_S) -> float:
	for tick: int in int(p_limit_s * HZ):
		await _tree.physics_frame
		if p_holds.call():
			return float(tick + 1) / HZ
	return INF
