extends TestCase
## What is known of a vehicle, and the extension behind it.


func test_a_new_state_is_a_whole_vehicle_at_rest() -> void:
	var state: VehicleState = VehicleState.new()
	equal(state.damage, VehicleState.Damage.WHOLE)
	equal(state.gear, 0)
	is_false(state.engine_on)


func test_the_engine_starts_at_idle() -> void:
	var drivetrain: VehicleDrivetrain = VehicleDrivetrain.new()
	var curve: PackedVector2Array = [Vector2(600, 2800), Vector2(1600, 4700), Vector2(2600, 4050)]
	drivetrain.set_engine(curve, 700.0, 2600.0, 5.0, 400.0, 0.3)
	almost_equal(drivetrain.get_rpm(), 700.0, 1.0)
	is_true(drivetrain.is_running())
