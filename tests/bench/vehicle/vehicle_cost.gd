class_name VehicleCost
extends VehicleCase
## What vehicles cost a server: time of a tick for each, while they drive in circles.

const WARM_UP: int = 120
const TICKS: int = 600
## Most of a tick that one tank may take, ms, and how many must run in real time.
const ONE_MS: float = 0.3
const AT_ONCE: Dictionary[String, int] = {"spheres": 10, "rays": 50}


func run() -> void:
	var empty: Vector2 = await _time(0)
	var name: String = "%s, %s" % [preset, gear]
	var one: Vector2 = await _time(1) - empty
	report.at_most(name, "1 costs a tick", one.x, "ms", ONE_MS)
	report.add(name, "of it processor time of the main thread", one.y, "ms")
	var count: int = AT_ONCE[gear]
	var many: Vector2 = await _time(count)
	var metric: String = "%d at once, a tick" % count
	report.at_most(name, metric, many.x, "ms", 1000.0 / 60.0)
	report.add(name, "each of them", (many.x - empty.x) / count, "ms")


## Time of a tick and, of it, processor time of the main thread (which tells more on a machine that
## does other things as well), ms.
func _time(p_count: int) -> Vector2:
	var ground: VehicleGround = flat_ground()
	for index: int in p_count:
		var at: Vector3 = Vector3(30.0 * (index % 8), 0.05, 30.0 * (index / 8))
		var vehicle: Vehicle = ground.add_vehicle(preset, kind, Transform3D(Basis.IDENTITY, at))
		vehicle.input.throttle = 0.4
		vehicle.input.steer = 0.6
	for _tick: int in WARM_UP:
		await tree.physics_frame
	var from: Vector2i = Vector2i(Time.get_ticks_usec(), ThreadClock.get_usec())
	for _tick: int in TICKS:
		await tree.physics_frame
	var spent: Vector2i = Vector2i(Time.get_ticks_usec(), ThreadClock.get_usec()) - from
	ground.free_all()
	await tree.physics_frame
	return 0.001 * Vector2(spent) / TICKS
