extends TestCase
## Loops at several values become one without a seam.


func test_no_loop_is_pitched_beyond_its_limits() -> void:
	var blend: LoopBlend = LoopBlend.new(VehicleSound.RPMS)
	for rpm: int in range(530, 3500, 7):
		blend.set_value(rpm)
		var power: float = 0.0
		for loop: int in blend.size():
			power += blend.gains[loop] * blend.gains[loop]
			if blend.gains[loop] > 0.0:
				almost_equal(blend.pitches[loop] * VehicleSound.RPMS[loop], rpm, 0.5, "%d" % rpm)
		almost_equal(power, 1.0, 1e-4, "power at %d" % rpm)


func test_gains_have_no_jumps() -> void:
	for values: PackedFloat32Array in [VehicleSound.RPMS, VehicleSound.SPEEDS]:
		var blend: LoopBlend = LoopBlend.new(values)
		var last: PackedFloat32Array = []
		var step: float = values[0] * 0.0005
		for number: int in 8000:
			blend.set_value(values[0] * 0.6 + number * step)
			for loop: int in last.size():
				is_true(absf(blend.gains[loop] - last[loop]) < 0.12, "loop %d" % loop)
			last = blend.gains.duplicate()


func test_beyond_both_ends_one_loop_goes_on() -> void:
	var blend: LoopBlend = LoopBlend.new(VehicleSound.RPMS)
	blend.set_value(0.0)
	equal(blend.gains[0], 1.0)
	almost_equal(blend.pitches[0], LoopBlend.MIN_PITCH)
	blend.set_value(9000.0)
	equal(blend.gains[3], 1.0)
	almost_equal(blend.pitches[3], LoopBlend.MAX_PITCH)
