class_name VehicleHatchDeck
extends VehicleCase
## People on the engine deck of a tank that drives gently for a minute, or brakes as hard as it can.

const SECONDS: float = 60.0
const GENTLE: float = 4.0


func run() -> void:
	for way: String in ["stands", "lies"]:
		await _ride(way)
	await _brake()


func _ride(p_way: String) -> void:
	var ground: VehicleGround = flat_ground()
	var vehicle: Vehicle = ground.add_vehicle("tank", kind)
	var rider: HatchRider = await _put(ground, vehicle, p_way == "lies")
	var from: Vector3 = vehicle.to_local(rider.hips())
	var worst: float = 0.0
	for tick: int in roundi(SECONDS * 60.0):
		var speed: float = VehicleGround.speed_of(vehicle)
		vehicle.input.throttle = 0.25 if speed < GENTLE else 0.0
		vehicle.input.steer = 0.15 * sin(tick / 240.0)
		rider.drive()
		await tree.physics_frame
		rider.measure()
		worst = maxf(worst, from.distance_to(vehicle.to_local(rider.hips())))
	var name: String = "deck, %s: %s while it drives gently" % [gear, p_way]
	var is_on: bool = vehicle.to_local(rider.hips()).y > 1.6
	report.at_least(name, "is on it after a minute", 1.0 if is_on else 0.0, "", 1.0)
	report.add(name, "moves on it", worst, "m")
	ground.free_all()
	await tree.physics_frame


## Stops from full speed: whoever stands there cannot stay.
func _brake() -> void:
	var ground: VehicleGround = flat_ground()
	var vehicle: Vehicle = ground.add_vehicle("tank", kind)
	var rider: HatchRider = await _put(ground, vehicle, false)
	var from: Vector3 = Vector3.ZERO
	var moved: float = 0.0
	for tick: int in 900:
		var is_braking: bool = tick > 600
		vehicle.input.throttle = 0.0 if is_braking else minf(tick / 600.0, 0.6)
		vehicle.input.brake = 1.0 if is_braking else 0.0
		rider.drive()
		await tree.physics_frame
		rider.measure()
		if tick == 600:
			from = vehicle.to_local(rider.hips())
		if tick > 600:
			moved = maxf(moved, from.distance_to(vehicle.to_local(rider.hips())))
	var name: String = "deck, %s: stands while it brakes hard" % gear
	report.at_least(name, "thrown by", moved, "m", 0.2)
	ground.free_all()
	await tree.physics_frame


func _put(p_ground: VehicleGround, p_vehicle: Vehicle, p_lies: bool) -> HatchRider:
	for _tick: int in 60:
		await tree.physics_frame
	var at: Vector3 = Vector3(0.9, 1.72, 3.0)
	var rider: HatchRider = HatchRider.new(p_ground, p_vehicle, Transform3D(Basis.IDENTITY, at))
	if p_lies:
		var pose: PoseSample = PoseSample.new()
		for limb: int in Limbs.COUNT:
			var turn: Quaternion = Quaternion(Vector3.BACK, 1.2 * _side_of(limb))
			# Across the deck: behind the turret there is no more room.
			var lying: Quaternion = Quaternion(Vector3.UP, PI / 2.0)
			pose.set_orientation(limb, lying * Quaternion(Vector3.RIGHT, -PI / 2.0) * turn)
		pose.root = Vector3(-0.9, 0.16, 0.0)
		rider.hold(pose)
	for _tick: int in 120:
		rider.drive()
		await tree.physics_frame
		rider.measure()
	return rider


## Arms lie beside the body.
static func _side_of(p_limb: int) -> float:
	if p_limb >= Limbs.LEFT_UPPER_ARM and p_limb <= Limbs.LEFT_HAND:
		return -1.0
	return 1.0 if p_limb >= Limbs.RIGHT_UPPER_ARM and p_limb <= Limbs.RIGHT_HAND else 0.0
