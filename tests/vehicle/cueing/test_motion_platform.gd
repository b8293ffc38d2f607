extends TestCase
## What a platform is described by, and that a filter keeps to it.

const _STEP_S: float = 0.005


func test_presets_have_no_faults_and_others_are_named() -> void:
	for name: String in MotionPlatform.PRESETS:
		equal(MotionPlatform.preset(name).find_fault(), "", name)
	is_null(MotionPlatform.preset("trampoline"))
	var platform: MotionPlatform = MotionPlatform.preset("small_hexapod")
	platform.speed.y = NAN
	contains(platform.find_fault(), "speed")
	platform = MotionPlatform.preset("small_hexapod")
	platform.angle.x = -3.0
	contains(platform.find_fault(), "angle")
	platform = MotionPlatform.preset("small_hexapod")
	platform.share = 0.0
	contains(platform.find_fault(), "share")


func test_every_preset_keeps_within_its_share() -> void:
	for name: String in MotionPlatform.PRESETS:
		var platform: MotionPlatform = MotionPlatform.preset(name)
		var cueing: MotionCueing = MotionCueing.new()
		platform.apply(cueing)
		WashoutParameters.new().apply(cueing)
		var random: RandomNumberGenerator = RandomNumberGenerator.new()
		random.seed = 7
		var farthest: Vector3 = Vector3.ZERO
		var steepest: Vector3 = Vector3.ZERO
		for _hit: int in 150:
			var force: Vector3 = _any(random, 40.0)
			var turn: Vector3 = _any(random, 3.0)
			for _step: int in 40:
				cueing.step(force, turn, _STEP_S)
				farthest = farthest.max(cueing.get_position().abs())
				steepest = steepest.max(cueing.get_attitude().abs())
		for axis: int in 3:
			var travel: float = platform.travel[axis] * platform.share
			var angle: float = deg_to_rad(platform.angle[axis] * platform.share)
			is_true(farthest[axis] <= travel + 1e-6, "%s %d" % [name, axis])
			is_true(steepest[axis] <= angle + 1e-6, "%s %d" % [name, axis])
		is_true(farthest.y > 0.02, name)


func _any(p_random: RandomNumberGenerator, p_most: float) -> Vector3:
	var vector: Vector3 = Vector3.ZERO
	for axis: int in 3:
		vector[axis] = p_random.randf_range(-p_most, p_most)
	return vector
