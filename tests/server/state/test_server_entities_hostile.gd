extends TestCase
## A tank is driven over the network while somebody else on board does what a crew must not: the
## server's own scene, over 127.0.0.1.

const CrewClient: GDScript = preload("res://tests/server/crew_client.gd")
const LinkPair: GDScript = preload("res://tests/net/link_pair.gd")

const TANK: String = "Tank"
## Ticks of each attack, and of driving undisturbed, that it is compared with.
const TICKS: int = 240
## By how much the median of a tick's processor time may grow under an attack, s: this finds what
## stalls the others, on a busy machine too.
const MAX_COST_S: float = 0.004
## The tank turns on the spot, there is no room for more; its tracks have at least this speed, m/s.
const DRIVING: float = 0.5
## Seat changes in a tick: 1000 a second.
const CHANGES: int = 17

var _server: Server = null
var _tank: Vehicle = null
var _driver: CrewClient = null
var _hostile: CrewClient = null
var _refusals: Dictionary[String, int] = {}
var _tick: int = 0


func goes_by_clock() -> bool:
	return true


func time_limit() -> float:
	return 300.0


func before_each() -> void:
	var port: int = LinkPair.free_port()
	var options: Options = Options.parse(
		ProgramOptions.rows(), ["--port=%d" % port, "--world=desert"], ProgramRoles.SERVER
	)
	equal(options.error, "")
	_server = preload("res://scenes/server/server.tscn").instantiate()
	_server.configure(options, ProgramParts.SERVER)
	add_child(_server)
	_tank = _server.find_child(TANK, true, false)
	_refusals.clear()
	_server.context().entities.command_refused.connect(_on_refused)
	_driver = CrewClient.new("driver", port)
	_hostile = CrewClient.new("hostile", port)
	await _until(func() -> bool: return _driver.knows(TANK) and _hostile.knows(TANK))
	_driver.command(TANK, Seat.TAKE, [0.0])
	await _until(func() -> bool: return _occupant(&"occupant") == _driver.session())
	await _run(300, _drive)
	is_true(absf(_tank.state.left_speed) > DRIVING, "%.1f m/s" % _tank.state.left_speed)


func after_each() -> void:
	_driver.leave()
	_hostile.leave()
	_server.free()


func test_a_thousand_seat_changes_a_second() -> void:
	var change: Callable = func() -> void:
		for number: int in CHANGES:
			if (_tick + number) % 5 == 4:
				_hostile.command(TANK, Seat.LEAVE)
			else:
				_hostile.command(TANK, Seat.TAKE, [float((_tick + number) % 4)])
	await _attack(change)
	_is_refused("takes seats faster than people can")
	is_true(_server.context().link.refused.get("commands", 0) > 0, "the rest counts as too many")
	await _run(30, _drive)
	_hostile.command(TANK, Seat.LEAVE)
	await _run(60, _drive)
	_hostile.command(TANK, Seat.TAKE, [1.0])
	await _run(30, _drive)
	equal(_occupant(&"gunner"), _hostile.session(), "it may sit again")


func test_commands_of_other_seats() -> void:
	await _sit(&"commander", 2.0)
	var rounds: int = _occupant(&"rounds")
	var wrong: Array[Array] = [
		[&"drive", [-1.0, 1.0, 1.0, 1.0, 3.0]],
		[&"engine", [0.0]],
		[&"lamps", [1.0]],
		[&"aim", [1.0, 1.0]],
		[&"stabilise", [0.0]],
		[&"fire", []],
		[&"fire_coax", [1.0]],
		[&"load", [1.0]],
		[&"open_loader_hatch", [1.0]],
		[&"upright", []],
		[&"repair", []],
	]
	var command: Callable = func() -> void:
		var one: Array = wrong[_tick % wrong.size()]
		var values: PackedFloat32Array = one[1]
		_hostile.command(TANK, one[0], values)
	await _attack(command)
	for seat: String in ["occupant", "gunner", "loader"]:
		_is_refused("does not sit in the %s's seat" % seat)
	_is_refused("'upright' is not for its role")
	_is_refused("'repair' is not for its role")
	equal(_tank.state.lamps, false)
	equal(_occupant(&"rounds"), rounds)
	equal((_tank.get_node(^"Turret") as VehicleTurret).aim, Vector2.ZERO)
	equal(_tank.state.loader_hatch, 0.0)


func test_bytes_that_are_no_values() -> void:
	await _sit(&"gunner", 1.0)
	var forge: Callable = func() -> void:
		var index: int = _hostile.number_of(TANK, [&"aim", &"load", &"fire"][_tick % 3])
		match _tick % 5:
			0:
				_hostile.forge(TANK, index, [0xFF, 0xFF, 0xFF, 0xFF])
			1:
				var floats: PackedFloat32Array = [NAN, INF]
				_hostile.forge(TANK, index, floats.to_byte_array())
			2:
				_hostile.forge(TANK, index, [1])
			3:
				var much: PackedByteArray = []
				much.resize(CommandMessage.MAX_BYTES)
				much.fill(0xFF)
				_hostile.forge(TANK, index, much)
			4:
				_hostile.forge(TANK, 200, [0])
	await _attack(forge)
	_is_refused("values that 'aim' cannot have")
	_is_refused("values that 'load' cannot have")
	_is_refused("has no command 200")
	equal((_tank.get_node(^"Turret") as VehicleTurret).aim, Vector2.ZERO)
	# A seat that there is not.
	_hostile.command(TANK, Seat.TAKE, [31.0])
	await _run(30, _drive)
	equal(_occupant(&"gunner"), _hostile.session())


func _drive() -> void:
	if _tick % 6 == 0:
		_driver.command(TANK, &"drive", [0.0, 1.0, 0.0, 0.0, 0.0])


## Drives on while the other one does something in each tick.
func _attack(p_trick: Callable) -> void:
	var before: float = await _work_of(_drive)
	var slowest: Array[float] = [INF]
	var work: Callable = func() -> void:
		_drive()
		p_trick.call()
		slowest[0] = minf(slowest[0], absf(_tank.state.left_speed))
	var after: float = await _work_of(work)
	print("  a tick's processor time, ms: %.2f, attacked %.2f" % [before * 1e3, after * 1e3])
	print("  %s" % _refusals)
	is_true(after - before < MAX_COST_S, "%.2f ms more" % [(after - before) * 1e3])
	equal(_occupant(&"occupant"), _driver.session())
	is_true(_tank.state.engine_on)
	is_true(slowest[0] > DRIVING, "it drives on, %.1f m/s at least" % slowest[0])
	is_true(_tank.global_transform.is_finite())


## Median of the processor time of a tick, s.
func _work_of(p_work: Callable) -> float:
	var before: int = _server.context().stats.sent_ticks
	await _run(TICKS, p_work)
	var count: int = _server.context().stats.sent_ticks - before
	is_true(count >= TICKS / 2, "%d of %d ticks were sent" % [count, TICKS])
	return _server.context().stats.work_time.percentile(0.5, count)


func _sit(p_field: StringName, p_index: float) -> void:
	_hostile.command(TANK, Seat.TAKE, [p_index])
	await _run(30, _drive)
	equal(_occupant(p_field), _hostile.session())


func _run(p_ticks: int, p_work: Callable) -> void:
	for _number: int in p_ticks:
		await get_tree().physics_frame
		_tick += 1
		p_work.call()
		_driver.poll()
		_hostile.poll()


func _until(p_holds: Callable) -> void:
	for _number: int in 6000:
		if p_holds.call():
			return
		await _run(1, func() -> void: pass)
	fail("it does not come")


func _occupant(p_field: StringName) -> int:
	return int(Entity.find_in(_tank).get_value(p_field))


func _is_refused(p_why: String) -> void:
	is_true(_refusals.keys().any(func(why: String) -> bool: return why.contains(p_why)), p_why)


func _on_refused(_session: int, p_why: String) -> void:
	_refusals[p_why] = _refusals.get(p_why, 0) + 1
