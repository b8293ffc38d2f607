extends TestCase
## What the instruments say in words.


func test_gears_by_letter_and_number() -> void:
	var state: VehicleState = VehicleState.new()
	equal(InstrumentPanel.describe_gear(state, VehicleInput.Selector.NEUTRAL), "Gear N")
	state.gear = 3
	equal(InstrumentPanel.describe_gear(state, VehicleInput.Selector.AUTOMATIC), "Gear A3")
	state.gear = -1
	equal(InstrumentPanel.describe_gear(state, VehicleInput.Selector.REVERSE), "Gear R1")


func test_what_a_crew_should_know() -> void:
	var state: VehicleState = VehicleState.new()
	state.engine_on = true
	equal(InstrumentPanel.describe_condition(state), "")
	state.engine_on = false
	state.damage = VehicleState.Damage.KNOCKED_OUT
	state.hatch = 1.0
	equal(InstrumentPanel.describe_condition(state), "KNOCKED OUT  engine off  hatch open")
