class_name VehicleCase
extends RefCounted
## A part of the benchmark of vehicles: what all of them are given.

## The tree that worlds are added to.
var tree: SceneTree = null
## Where values go.
var report: BenchReport = null
## The vehicle: tank, carrier, truck or scootmobile.
var preset: String = "tank"
## The running gear by its name, and as what it is.
var gear: String = "spheres"
var kind: VehicleParameters.GearKind = VehicleParameters.GearKind.SPHERES
## Of simulated driving, for cases that take long.
var minutes: float = 1.0


## A world of its own with flat ground.
func flat_ground() -> VehicleGround:
	var ground: VehicleGround = VehicleGround.new(tree.root)
	ground.add_floor()
	return ground


## Steers straight ahead along -Z at a speed, m/s.
static func drive_ahead(p_vehicle: Vehicle, p_speed: float) -> void:
	var missing: float = p_speed - VehicleGround.speed_of(p_vehicle)
	p_vehicle.input.throttle = clampf(0.15 + 0.5 * missing, 0.0, 1.0)
	var ahead: float = p_vehicle.global_basis.z.x
	p_vehicle.input.steer = clampf(0.05 * p_vehicle.position.x - 0.6 * ahead, -0.5, 0.5)


## Measures, and adds values to the report.
func run() -> void:
	pass
