extends TestCase
## What a spectator sees out of somebody's eyes is calm, and not late.

const STEP_S: float = 1.0 / 60.0


func test_shakes_are_hardly_seen() -> void:
	var eye: SteadyEye = SteadyEye.new()
	var least: float = INF
	var most: float = -INF
	for frame: int in 600:
		# A head that nods by 2 degrees four times a second.
		var pitch: float = deg_to_rad(2.0) * sin(TAU * 4.0 * frame * STEP_S)
		var shown: Transform3D = eye.advance(Transform3D(Basis(Vector3.RIGHT, pitch)), STEP_S)
		if frame > 120:
			least = minf(least, shown.basis.get_euler().x)
			most = maxf(most, shown.basis.get_euler().x)
	is_true(most - least < deg_to_rad(4.0) * 0.35, "%.2f degrees" % rad_to_deg(most - least))


func test_quick_looks_are_followed() -> void:
	var eye: SteadyEye = SteadyEye.new()
	eye.advance(Transform3D.IDENTITY, STEP_S)
	var behind: float = 0.0
	for frame: int in 60:
		var yaw: float = minf(frame * STEP_S * 4.0, PI / 2.0)
		var shown: Transform3D = eye.advance(Transform3D(Basis(Vector3.UP, yaw)), STEP_S)
		behind = absf(angle_difference(shown.basis.get_euler().y, yaw))
		is_true(behind <= SteadyEye.MAX_ANGLE + 0.001, "%.3f rad behind" % behind)
	is_true(behind < deg_to_rad(3.0), "%.1f degrees are left" % rad_to_deg(behind))


func test_it_does_not_roll_and_survives_a_look_straight_down() -> void:
	var eye: SteadyEye = SteadyEye.new()
	var rolled: Basis = Basis(Vector3.BACK, deg_to_rad(30.0))
	var shown: Transform3D = eye.advance(Transform3D(rolled), STEP_S)
	almost_equal(rad_to_deg(shown.basis.get_euler().z), 0.0, 0.01)
	for pitch: float in [-PI / 2.0, -1.5, 1.5, PI / 2.0]:
		is_true(eye.advance(Transform3D(Basis(Vector3.RIGHT, pitch)), STEP_S).is_finite())


func test_a_teleport_is_a_cut() -> void:
	var eye: SteadyEye = SteadyEye.new()
	eye.advance(Transform3D.IDENTITY, STEP_S)
	var there: Transform3D = Transform3D(Basis(Vector3.UP, 2.0), Vector3(10.0, 0.0, 3.0))
	almost_equal(eye.advance(there, STEP_S).origin, there.origin, 1e-6)
