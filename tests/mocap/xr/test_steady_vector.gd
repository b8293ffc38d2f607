extends TestCase
## Noise is filtered at rest; motion is followed.


func test_noise_shrinks_and_motion_does_not_lag() -> void:
	var random: RandomNumberGenerator = RandomNumberGenerator.new()
	random.seed = 3
	var steady: SteadyVector = SteadyVector.new()
	var raw: float = 0.0
	var left: float = 0.0
	for _step: int in 600:
		var noise: Vector3 = Vector3(random.randfn(), 0.0, 0.0) * 0.0005
		steady.advance(noise, 1.0 / 60.0)
		raw += noise.length_squared()
		left += steady.value.length_squared()
	is_true(sqrt(left / raw) < 0.6, "noise by %f" % sqrt(left / raw))
	for speed: float in [0.1, 1.0, 3.0]:
		steady = SteadyVector.new()
		for step: int in 120:
			steady.advance(Vector3(step / 60.0 * speed, 0.0, 0.0), 1.0 / 60.0)
		var lag: float = 119.0 / 60.0 * speed - steady.value.x
		is_true(lag < 0.0101, "%f m behind at %f m/s" % [lag, speed])


func test_it_begins_where_the_value_is() -> void:
	var steady: SteadyVector = SteadyVector.new()
	steady.advance(Vector3.ONE, 0.0)
	equal(steady.value, Vector3.ONE)
	steady.restart()
	steady.advance(Vector3.ZERO, 0.01)
	equal(steady.value, Vector3.ZERO)
