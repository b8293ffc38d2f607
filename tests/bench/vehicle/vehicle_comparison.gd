class_name VehicleComparison
extends VehicleCase
## How the two running gears differ: straight on, turning, slipping on a slope, ride.


func run() -> void:
	var courses: VehicleCourses = VehicleCourses.new(tree, preset, kind)
	var name: String = "%s, %s" % [preset, gear]
	var straight: Vector2 = await courses.top_speed()
	report.add(name, "drift straight on over 300 m", straight.y, "m")
	if preset == "tank" or preset == "carrier":
		var turn: Vector2 = await courses.turn_on_the_spot()
		report.add(name, "off its place after a turn on the spot", turn.y, "m")
	report.add(name, "radius of a full turn at 3 m/s", await courses.turning_radius(3.0), "m")
	var slip: float = await courses.slip_along(0.3)
	report.add(name, "slip over 40 m along a slope of 30 %", slip, "m")
	if preset == "scootmobile":
		return  # Too slow for what follows.
	report.add(name, "radius of a full turn at 8 m/s", await courses.turning_radius(8.0), "m")
	var ride: Vector2 = await courses.ride(30.0 / 3.6)
	report.add(name, "driver's acceleration over 0.3 m bumps at 30 km/h", ride.x, "m/s^2 RMS")
	report.add(name, "largest pitch there", ride.y, "deg")
