extends TestCase
## Kinds of rounds: what makes sense, and what a shot gives to the gun.

const FOLDER: String = "res://scenes/combat/ammunition/"


func test_all_presets_make_sense_and_fly() -> void:
	for file: String in DirAccess.get_files_at(FOLDER):
		var kind: Ammunition = load(FOLDER + file.trim_suffix(".remap"))
		equal(kind.find_fault(), "", file)
		var flight: ShellFlight = kind.make_flight()
		is_true(flight.launch(Vector3.ZERO, Vector3.FORWARD * kind.muzzle_speed), file)
		is_true(flight.advance(1.0), file)
		is_true(flight.get_velocity().length() < kind.muzzle_speed, file)
		is_true(flight.get_position().y < -3.0, file)


func test_recoil_is_the_shots_and_the_gases_momentum() -> void:
	var dart: Ammunition = load(FOLDER + "dart_120.tres")
	almost_equal(dart.recoil(), 7.3 * 1650.0 + 7.6 * 1400.0, 1.0)
	var ball: Ammunition = load(FOLDER + "ball_7_62.tres")
	almost_equal(ball.recoil(), 11.6, 0.1)


func test_a_dart_gets_through_less_when_it_is_slow_and_a_hollow_charge_does_not() -> void:
	var dart: Ammunition = load(FOLDER + "dart_120.tres")
	almost_equal(dart.penetration_at(825.0), dart.penetration / 4.0, 1e-3)
	var hollow: Ammunition = load(FOLDER + "heat_120.tres")
	almost_equal(hollow.penetration_at(300.0), hollow.penetration, 1e-3)


func test_what_makes_no_sense_is_named() -> void:
	var cases: Dictionary[StringName, float] = {
		&"mass": 0.0, &"muzzle_speed": NAN, &"calibre": -1.0, &"drag_coefficient": INF
	}
	for name: StringName in cases:
		var kind: Ammunition = Ammunition.new()
		equal(kind.find_fault(), "")
		kind.set(name, cases[name])
		is_true(kind.find_fault().begins_with(name), kind.find_fault())
		is_true(kind.make_flight() == null)
