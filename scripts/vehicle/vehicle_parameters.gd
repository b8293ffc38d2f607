@tool
class_name VehicleParameters
extends Resource
## What a vehicle is: its mass, wheels, engine, gears, brakes and steering.
##
## [code]docs/vehicles.md[/code] says where the presets have their values from.
## [VehicleCheck] names what makes no sense.

## What is between hull and ground.
enum GearKind {
	## Rigid spheres on damped sliders: [SphereRunningGear]. For tracks.
	SPHERES,
	## Rays: [RayRunningGear]. For wheels, and for many tracked vehicles at once.
	RAYS,
}

## How the vehicle is steered.
enum Steering {
	## One track faster than the other.
	TRACKS,
	## Wheels that turn.
	WHEELS,
}

@export_group("Body")
## Mass of the whole vehicle with its wheels, kg.
@export_range(1.0, 200000.0, 1.0, "or_greater", "suffix:kg") var mass: float = 10000.0
## Where the centre of mass of the hull is in its frame, m.
@export_custom(PROPERTY_HINT_NONE, "suffix:m") var centre_of_mass: Vector3 = Vector3(0.0, 1.0, 0.0)
## Size of the box of even density that has the hull's inertia, m.
@export_custom(PROPERTY_HINT_NONE, "suffix:m") var inertia_box: Vector3 = Vector3(3.0, 2.0, 6.0)
## Drag coefficient times the area of the front, m^2.
@export_range(0.0, 50.0, 0.01, "suffix:m^2") var drag_area: float = 5.0

@export_group("Running gear")
## What is between hull and ground.
@export var gear_kind: GearKind = GearKind.SPHERES
## The wheels as spheres.
@export var spheres: Array[VehicleWheel] = []
## The wheels as rays.
@export var rays: Array[VehicleWheel] = []
## Force that it takes to keep rolling, as a share of the weight.
@export_range(0.0, 0.3, 0.001) var rolling_resistance: float = 0.03

@export_group("Engine", "engine_")
## Torque (y, N m) over speed (x, 1/min) at full load, by rising speed.
@export var engine_curve: PackedVector2Array = PackedVector2Array()
## Speed that the governor holds when nobody accelerates, 1/min; 0 for an electric motor.
@export_range(0.0, 20000.0, 1.0, "suffix:1/min") var engine_idle_rpm: float = 700.0
## Highest speed that the governor allows, 1/min.
@export_range(1.0, 20000.0, 1.0, "suffix:1/min") var engine_max_rpm: float = 2600.0
## Inertia of all that turns with the crankshaft, kg m^2.
@export_range(0.001, 100.0, 0.001, "suffix:kg m^2") var engine_inertia: float = 1.0
## Torque that the engine brakes with at its highest speed, N m.
@export_range(0.0, 10000.0, 0.1, "suffix:N m") var engine_friction: float = 100.0
## Time constant in which the torque follows the pedal, s.
@export_range(0.0, 5.0, 0.01, "suffix:s") var engine_response: float = 0.2

@export_group("Gearbox", "gearbox_")
## Ratios of the forward gears, first gear first: turns of the engine for one turn of the wheel,
## final drive included.
@export var gearbox_forward: PackedFloat32Array = PackedFloat32Array()
## Ratios of the reverse gears, likewise.
@export var gearbox_reverse: PackedFloat32Array = PackedFloat32Array()
## Radius of the wheels that the gears are made for, m.
@export_range(0.01, 5.0, 0.001, "suffix:m") var gearbox_wheel_radius: float = 0.6
## Share of the power that reaches the wheels.
@export_range(0.05, 1.0, 0.01) var gearbox_efficiency: float = 0.85
## Time for which a shift interrupts the drive, s.
@export_range(0.0, 3.0, 0.01, "suffix:s") var gearbox_shift_time: float = 0.4
## Share of the engine's highest speed at which it shifts up at full throttle.
@export_range(0.3, 1.0, 0.01) var gearbox_up_share: float = 0.94
## Share of the engine's highest speed below which it shifts down at full throttle.
@export_range(0.1, 0.9, 0.01) var gearbox_down_share: float = 0.5
## Torque ratio of the converter at stall; 1: there is no converter.
@export_range(1.0, 4.0, 0.01) var gearbox_stall_ratio: float = 2.0
## Stall speed: speed that the engine reaches at full load when the vehicle stands, 1/min.
@export_range(100.0, 10000.0, 1.0, "suffix:1/min") var gearbox_stall_rpm: float = 1700.0
## Ratio of turbine to pump from which a clutch bridges the converter.
@export_range(0.5, 0.98, 0.01) var gearbox_lock_share: float = 0.85

@export_group("Brakes", "brake_")
## Force of all brakes together at the ground, N.
@export_range(0.0, 2000000.0, 1.0, "suffix:N") var brake_force: float = 50000.0
## Force of the parking brake, which also holds the vehicle where nobody drives, N.
@export_range(0.0, 2000000.0, 1.0, "suffix:N") var brake_parking_force: float = 50000.0

@export_group("Steering", "steering_")
## How the vehicle is steered.
@export var steering_kind: Steering = Steering.TRACKS
## Greatest lateral acceleration that steering allows, m/s^2.
@export_range(0.1, 20.0, 0.1, "suffix:m/s^2") var steering_most_sideways: float = 3.5
## Tracks: distance between their middles (tread), m.
@export_range(0.1, 10.0, 0.01, "suffix:m") var steering_tread: float = 2.8
## Tracks: speed of each in opposite directions when turning on the spot, m/s.
@export_range(0.0, 10.0, 0.01, "suffix:m/s") var steering_pivot_speed: float = 1.5
## Tracks: greatest steering force on each, N.
@export_range(0.0, 1000000.0, 1.0, "suffix:N") var steering_force: float = 200000.0
## Tracks: time constant of the steering, s.
@export_range(0.01, 3.0, 0.01, "suffix:s") var steering_response: float = 0.25
## Wheels: distance of the axles, m.
@export_range(0.1, 20.0, 0.01, "suffix:m") var steering_wheelbase: float = 3.0
## Wheels: largest angle, rad.
@export_range(0.0, 1.4, 0.001, "radians_as_degrees") var steering_max_angle: float = 0.6
## Wheels: how fast they turn, rad/s.
@export_range(0.01, 10.0, 0.01, "suffix:rad/s") var steering_rate: float = 1.0


## The wheels of the running gear that is chosen, or of another.
func wheels_of(p_kind: GearKind) -> Array[VehicleWheel]:
	return spheres if p_kind == GearKind.SPHERES else rays
