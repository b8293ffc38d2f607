extends TestCase
## Values of fields on the wire: steps, ranges, angles.

const Samples: GDScript = preload("res://tests/entity/entity_samples.gd")


func test_every_value_is_restored_within_half_a_step() -> void:
	var random: RandomNumberGenerator = RandomNumberGenerator.new()
	random.seed = 1
	for _time: int in 500:
		var field: EntityField = Samples.random_field(random, "x")
		equal(field.find_fault(), "")
		var value: float = random.randf_range(field.min_value, field.max_value)
		var restored: float = field.quantize(value)
		var error: float = absf(restored - value)
		if field.kind == EntityField.Kind.ANGLE:
			error = minf(error, field.max_value - field.min_value - error)
		is_true(error <= field.resolution * 0.501, "off by %f steps" % (error / field.resolution))
		equal(field.to_step(restored), field.to_step(field.quantize(restored)))


func test_values_out_of_range_are_the_nearest_in_range() -> void:
	var field: EntityField = EntityField.create(&"x", EntityField.Kind.LINEAR, -1.0, 3.0, 0.5)
	equal([field.to_step(-9.0), field.to_step(9.0), field.to_step(NAN)], [0, 8, 0])
	equal(field.quantize(INF), -1.0)


func test_angles_wrap() -> void:
	var field: EntityField = EntityField.create(&"a", EntityField.Kind.ANGLE, -180.0, 180.0, 1.0)
	equal(field.to_step(180.0), field.to_step(-180.0))
	equal(field.quantize(190.0), -170.0)
	equal(field.quantize(-541.0), 179.0)


func test_sizes_follow_the_number_of_steps() -> void:
	equal(EntityField.create_count(&"x", 255).size(), 1)
	equal(EntityField.create_count(&"x", 256).size(), 2)
	equal(EntityField.create_count(&"x", 65536).size(), 4)


func test_faults_say_what_to_do() -> void:
	var field: EntityField = EntityField.create_count(&"x", 10)
	field.name = &""
	contains(field.find_fault(), "name")
	for bad: Array in [[1.0, 0.0, 0.1], [0.0, 1.0, 0.0], [0.0, 1e9, 1.0], [NAN, 1.0, 0.1]]:
		var wrong: EntityField = EntityField.create(
			&"x", EntityField.Kind.LINEAR, bad[0], bad[1], bad[2]
		)
		contains(wrong.find_fault(), "'x'")
