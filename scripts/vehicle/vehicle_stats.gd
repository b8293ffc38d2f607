class_name VehicleStats
extends RefCounted
## What a vehicle's wheels and drivetrain do at one moment, for plots, sounds and dust. The arrays
## have one value for each wheel, in the order of the parameters.

## How far springs are compressed, m.
var compressions: PackedFloat32Array = PackedFloat32Array()
## Forces of springs and dampers, N.
var spring_forces: PackedFloat32Array = PackedFloat32Array()
## Speeds at the rims over the hull, m/s, forward positive.
var wheel_speeds: PackedFloat32Array = PackedFloat32Array()
## Speeds at which wheels slip over the ground, m/s.
var slips: PackedFloat32Array = PackedFloat32Array()
## 1 for a wheel that touches the ground, else 0.
var contacts: PackedByteArray = PackedByteArray()
## Where wheels touch the ground, in the world, m.
var contact_points: PackedVector3Array = PackedVector3Array()
## Velocities of the ground at these points, m/s.
var ground_velocities: PackedVector3Array = PackedVector3Array()
## Speed of the engine, 1/min.
var rpm: float = 0.0
## The gear that is in: 1 and up forward, -1 and down reverse, 0 none.
var gear: int = 0
## Torque at the engine's shaft, N m; below zero it brakes.
var torque: float = 0.0
## Drive of the left side at the ground, N, without brakes.
var left_force: float = 0.0
## Drive of the right side at the ground, N, without brakes.
var right_force: float = 0.0


## Reads a running gear and its drivetrain.
static func read(p_gear: RunningGear, p_drivetrain: VehicleDrivetrain) -> VehicleStats:
	var stats: VehicleStats = VehicleStats.new()
	for wheel: int in p_gear.get_wheel_count():
		stats.compressions.append(p_gear.get_wheel_compression(wheel))
		stats.spring_forces.append(p_gear.get_wheel_load(wheel))
		stats.wheel_speeds.append(p_gear.get_wheel_speed(wheel))
		stats.slips.append(p_gear.get_wheel_slip(wheel))
		stats.contacts.append(1 if p_gear.is_wheel_on_ground(wheel) else 0)
		stats.contact_points.append(p_gear.get_contact_point(wheel))
		stats.ground_velocities.append(p_gear.get_ground_velocity(wheel))
	stats.rpm = p_drivetrain.get_rpm()
	stats.gear = p_drivetrain.get_gear()
	stats.torque = p_drivetrain.get_torque()
	stats.left_force = p_drivetrain.get_left_force()
	stats.right_force = p_drivetrain.get_right_force()
	return stats
