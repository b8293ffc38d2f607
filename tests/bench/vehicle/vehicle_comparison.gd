class_name VehicleComparison
extends RefCounted
## How the two running gears differ: straight on, turning, slipping on a slope, ride.


static func run(
	p_tree: SceneTree,
	p_report: BenchReport,
	p_preset: String,
	p_gear: String,
	p_kind: VehicleParameters.GearKind
) -> void:
	var courses: VehicleCourses = VehicleCourses.new(p_tree, p_preset, p_kind)
	var name: String = "%s, %s" % [p_preset, p_gear]
	var straight: Vector2 = await courses.top_speed()
	p_report.add(name, "drift straight on over 300 m", straight.y, "m")
	if p_preset == "tank" or p_preset == "carrier":
		var turn: Vector2 = await courses.turn_on_the_spot()
		p_report.add(name, "off its place after a turn on the spot", turn.y, "m")
	p_report.add(name, "radius of a full turn at 3 m/s", await courses.turning_radius(3.0), "m")
	var slip: float = await courses.slip_along(0.3)
	p_report.add(name, "slip over 40 m along a slope of 30 %", slip, "m")
	if p_preset == "scootmobile":
		return  # Too slow for what follows.
	p_report.add(name, "radius of a full turn at 8 m/s", await courses.turning_radius(8.0), "m")
	var ride: Vector2 = await courses.ride(30.0 / 3.6)
	p_report.add(name, "driver's acceleration over 0.3 m bumps at 30 km/h", ride.x, "m/s^2 RMS")
	p_report.add(name, "largest pitch there", ride.y, "deg")
