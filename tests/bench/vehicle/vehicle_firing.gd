class_name VehicleFiring
extends VehicleCase
## What shooting costs and does: shells in the air, their flight beside a reference, the hull's
## rocking, and what becomes of a crate and a person.

const _FOLDER: String = "res://scenes/combat/ammunition/%s.tres"
const _TICK: float = 1.0 / 60.0
## Shells in the air, and ticks over which they are timed.
const _MANY: int = 100
const _TICKS: int = 120
## Most that a flight in ticks may be off the same in steps of 1 ms after 2 s, mm.
const _MAX_ERROR_MM: float = 10.0
## How far the hull of a tank of 55 t is to pitch for a shot of the gun, deg: what was asked for,
## not a measurement of a real one.
const _PITCH_DEG: Vector2 = Vector2(1.0, 2.0)


func run() -> void:
	for round: String in ["dart_120", "heat_120", "ball_7_62", "ball_12_7"]:
		_fly(load(_FOLDER % round))
	await _rock()
	await _cost()
	await _hit()


## Level flight over 1000 m, and how far a tick's steps are off.
func _fly(p_kind: Ammunition) -> void:
	var flight: ShellFlight = p_kind.make_flight()
	flight.launch(Vector3.ZERO, Vector3.FORWARD * p_kind.muzzle_speed)
	while -flight.get_position().z < 1000.0:
		var left: float = (1000.0 + flight.get_position().z) / flight.get_velocity().length()
		flight.advance(clampf(left, 1e-7, _TICK))
	report.add(p_kind.title, "time to 1000 m", flight.get_age(), "s")
	report.add(p_kind.title, "drop at 1000 m", -flight.get_position().y, "m")
	report.add(p_kind.title, "speed at 1000 m", flight.get_velocity().length(), "m/s")
	var ends: PackedVector3Array = []
	for step: float in [_TICK, 0.001]:
		flight.launch(Vector3.ZERO, Vector3(0.0, 0.2, -0.98) * p_kind.muzzle_speed)
		for _step: int in roundi(2.0 / step):
			flight.advance(step)
		ends.append(flight.get_position())
	var off: float = 1000.0 * ends[0].distance_to(ends[1])
	report.at_most(p_kind.title, "off steps of 1 ms after 2 s", off, "mm", _MAX_ERROR_MM)


func _rock() -> void:
	for number: int in 2:
		for way: String in ["ahead", "to the side"]:
			var firing: FiringRange = FiringRange.new(tree.root)
			await firing.settle()
			firing.gun.load_kind(number)
			firing.gun.loaded = 1.0
			var middle: Vector3 = firing.gun.global_position
			var ahead: Vector3 = Vector3(0, 0, -500) if way == "ahead" else Vector3(-500, 0, 0)
			firing.aim_at(middle + ahead)
			await firing.ground.run(1.0)
			var rest: Vector3 = firing.tank.global_basis.y
			firing.gun.fire()
			var most: float = 0.0
			for _tick: int in 90:
				await tree.physics_frame
				most = maxf(most, rad_to_deg(firing.tank.global_basis.y.angle_to(rest)))
			var name: String = "%s, %s" % [firing.gun.ammunition[number].title, way]
			if way != "ahead":
				report.add(name, "hull rocks", most, "deg")
			else:
				report.at_least(name, "hull pitches at least", most, "deg", _PITCH_DEG.x)
				report.at_most(name, "and at most", most, "deg", _PITCH_DEG.y)
			firing.free_all()


func _cost() -> void:
	var firing: FiringRange = FiringRange.new(tree.root)
	await firing.settle()
	for number: int in 60:
		firing.add_crate(Vector3(4.0 * (number % 10) - 20.0, 0.4, -40.0 - 8.0 * (number / 10)))
	firing.shells.set_physics_process(false)
	for name: String in ["dart_120", "ball_7_62"]:
		var round: Ammunition = load(_FOLDER % name)
		var from: Vector3 = Vector3(0.0, 2.0, -20.0)
		for number: int in _MANY:
			var way: Vector3 = Vector3(0.01 * number - 0.5, 0.7, -1.0).normalized()
			firing.shells.launch(round, from, from, way * round.muzzle_speed)
		var start: int = Time.get_ticks_usec()
		for _tick: int in _TICKS:
			firing.shells._physics_process(_TICK)
		var spent: float = float(Time.get_ticks_usec() - start) / _TICKS
		var left: int = firing.shells.flying().size()
		report.add("%d of %s in the air" % [left, round.title], "cost a tick", spent, "us")
		firing.shells.flying().clear()
	firing.free_all()


func _hit() -> void:
	for size: float in [0.3, 0.8]:
		var firing: FiringRange = FiringRange.new(tree.root)
		await firing.settle()
		var crate: RigidBody3D = firing.add_crate(
			Vector3(0.0, size / 2.0, -60.0), 40.0 * size * size * size, size
		)
		await firing.ground.run(0.5)
		firing.aim_at(crate.global_position)
		await firing.ground.run(0.1)
		firing.gun.dispersion = 0.0
		firing.gun.fire()
		var fastest: float = 0.0
		for _tick: int in 120:
			await tree.physics_frame
			fastest = maxf(fastest, crate.linear_velocity.length())
		var most: float = ShellHits.MAX_GAIN + 1.0
		var name: String = "a dart hits a crate of %.1f kg" % crate.mass
		report.at_most(name, "fastest", fastest, "m/s", most)
		report.at_least(name, "hits", firing.hits.size(), "", 1.0)
		firing.free_all()
	for case: String in ["machine gun, 1 s", "dart", "burst 1.5 m away"]:
		await _hit_person(case)


func _hit_person(p_case: String) -> void:
	var firing: FiringRange = FiringRange.new(tree.root)
	await firing.settle()
	var person: Ragdoll = firing.add_person(Vector3(0.0, 0.0, -30.0))
	var source: BvhSource = BvhSource.new()
	source.open("res://assets/motion/01_01.bvh")
	var sample: PoseSample = source.pose_at(0.5)
	var chest: Node3D = person.get_simulator().get_node("Chest")
	var hips: Node3D = person.get_simulator().get_node("Hips")
	var lowest: float = INF
	var fastest: float = 0.0
	for tick: int in 360:
		person.push_sample(tick / 60.0, sample, Vector3(0.0, sample.root.y, -30.0))
		person.drive(tick / 60.0, _TICK)
		await tree.physics_frame
		if tick == 110:
			firing.aim_at(chest.global_position)
		if tick == 120:
			match p_case:
				"dart":
					firing.gun.fire()
				"machine gun, 1 s":
					firing.coax.hold_trigger(true)
				_:
					var at: Vector3 = Vector3(0.0, 0.3, -28.5)
					ShellHits.burst(firing.space(), at, firing.gun.ammunition[1])
		if tick == 180:
			firing.coax.hold_trigger(false)
		lowest = minf(lowest, hips.global_position.y)
		for body: RID in person.get_bodies():
			var state: PhysicsDirectBodyState3D = PhysicsServer3D.body_get_direct_state(body)
			fastest = maxf(fastest, state.linear_velocity.length())
	var name: String = "a person, " + p_case
	report.at_most(name, "fastest limb", fastest, "m/s", 25.0)
	if p_case.begins_with("machine"):
		report.at_least(name, "lowest hips", lowest, "m", 0.7)
	else:
		report.at_most(name, "lowest hips", lowest, "m", 0.6)
	firing.free_all()
