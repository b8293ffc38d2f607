class_name VehicleHatch
extends VehicleCase
## The suited trainee in the commander's hatch: over level ground, over bumps, with the gun firing
## and the turret turning; in and out a hundred times; and people on the deck.

const CLIPS: Array[String] = ["", "01_01", "Boxing_Toes", "01_03"]
## What a case drives over and does besides.
const CASES: Array[String] = ["level", "bumps", "bumps, turret turns, a shot every 10 s"]
const SPEED: float = 30.0 / 3.6
const SETTLE_TICKS: int = 240
## How far hips may be from the middle of a hatch of 0.31 m: what is left beside them.
const MOST_ACROSS_M: float = 0.15
const MOST_UP_M: float = 1.15
const DEEPEST_M: float = 0.02
const UPPER_DEG: float = 3.0
const RECOIL_NS: float = 25e3
const SHOT_TICKS: int = 600

var _ground: VehicleGround = null
var _vehicle: Vehicle = null
var _turret: VehicleTurret = null
var _seat: VehicleSeat = null
var _rider: HatchRider = null
var _tick: int = 0


func run() -> void:
	for case: String in CASES:
		for clip: String in CLIPS:
			_begin(case != "level")
			await _ride(case, clip)
	_begin(false)
	await _change()
	var deck: VehicleHatchDeck = VehicleHatchDeck.new()
	for property: StringName in [&"tree", &"report", &"gear", &"kind"]:
		deck.set(property, get(property))
	await deck.run()


func _begin(p_has_bumps: bool) -> void:
	_tick = 0
	_ground = VehicleGround.new(tree.root)
	if p_has_bumps:
		_ground.view.add_child(VehicleBumps.create(VehicleBumps.END_M + SPEED * 60.0 * minutes))
	else:
		_ground.add_box(Vector3(6000, 2, 6000), Transform3D(Basis.IDENTITY, Vector3.DOWN))
	_vehicle = _ground.add_vehicle("tank", kind, Transform3D(Basis.IDENTITY, Vector3.UP * 0.02))
	_turret = _vehicle.get_node(^"Turret")
	_seat = _vehicle.get_node(^"Turret/CommanderSeat")
	var beside: Transform3D = Transform3D(Basis.IDENTITY, Vector3(-2.6, 0.0, -2.4))
	_rider = HatchRider.new(_ground, _vehicle, beside)


func _step() -> void:
	_rider.drive()
	await tree.physics_frame
	_rider.measure()
	_tick += 1


func _enter() -> void:
	_rider.people.attach(HatchRider.SESSION, 1024, _vehicle, _seat)


func _is_in() -> bool:
	var sitting: PersonSeat = _rider.person.sitting
	return sitting != null and sitting.phase == PersonSeat.Phase.SITTING


func _ride(p_case: String, p_clip: String) -> void:
	for _number: int in 60:
		await _step()
	_enter()
	for _number: int in SETTLE_TICKS:
		await _step()
	if p_clip != "":
		_rider.play("res://assets/motion/%s.bvh" % p_clip)
	var is_full: bool = p_case == CASES[2]
	for _number: int in SETTLE_TICKS:
		drive_ahead(_vehicle, SPEED)
		await _step()
	for number: int in roundi(minutes * 3600.0):
		drive_ahead(_vehicle, SPEED)
		if is_full:
			_turret.aim = Vector2(1.0, 0.0)
			if number % SHOT_TICKS == 0:
				_shoot()
		await _step()
		_rider.note()
	_report_ride(p_case, "stands" if p_clip == "" else p_clip)
	_ground.free_all()
	await tree.physics_frame


func _shoot() -> void:
	var muzzle: Node3D = _turret.get_node(^"Gun/Muzzle")
	_vehicle.apply_recoil(muzzle.global_basis.z * RECOIL_NS, muzzle.global_position)


func _report_ride(p_case: String, p_clip: String) -> void:
	var name: String = "hatch, %s, %s: %s" % [gear, p_case, p_clip]
	if _rider.error_count == 0:
		report.leave_out(name, "nothing was measured")
		return
	var is_level: bool = p_case == "level"
	var fitted: String = "upper body off its motion as the hatch has room for it, mean"
	report.at_most(name, fitted, _rider.mean_deg(), "deg", UPPER_DEG, is_level)
	var free: String = "limbs that have room, off what the wearer does, mean"
	report.at_most(name, free, _rider.free_deg(), "deg", UPPER_DEG, is_level)
	report.add(name, "limbs that have room", _rider.free_share(), "%")
	report.add(name, "all limbs, off what the wearer does, mean", _rider.raw_deg(), "deg")
	report.at_most(name, "hips off the middle", _rider.hips_across, "m", MOST_ACROSS_M)
	report.at_most(name, "hips above the soles", _rider.hips_highest, "m", MOST_UP_M)
	report.at_least(name, "lowest hips", _rider.hips_lowest, "m", 0.25)
	report.at_most(name, "limb in steel", _rider.deepest, "m", DEEPEST_M)
	report.at_most(name, "fastest limb", _rider.fastest, "m/s", 25.0)
	var is_seated: bool = _is_in()
	report.at_least(name, "still in the hatch", 1.0 if is_seated else 0.0, "", 1.0)


## In and out again a hundred times.
func _change() -> void:
	var stuck: int = 0
	var slowest: int = 0
	for number: int in 100:
		_enter()
		var ticks: int = 0
		while not _is_in() and ticks < 400:
			await _step()
			ticks += 1
		stuck += 0 if _is_in() else 1
		slowest = maxi(slowest, ticks)
		_rider.people.detach(HatchRider.SESSION)
		ticks = 0
		while _rider.person.carrier != null and ticks < 400:
			await _step()
			ticks += 1
		stuck += 0 if _rider.person.carrier == null else 1
		slowest = maxi(slowest, ticks)
		for _number: int in 30:
			await _step()
		var local: Vector3 = _vehicle.to_local(_rider.hips())
		var is_beside: bool = absf(local.x) > 1.9 or absf(local.z) > 3.6
		stuck += 0 if is_beside and local.y < 1.3 and local.y > 0.6 else 1
	var name: String = "hatch, %s: in and out 100 times" % gear
	report.at_most(name, "stuck", stuck, "", 0.0)
	report.at_most(name, "longest way", slowest / 60.0, "s", 3.5)
	_ground.free_all()
	await tree.physics_frame
