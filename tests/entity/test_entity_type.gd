extends TestCase
## Types on the wire: what is told of them at join, and what is refused.

const Samples: GDScript = preload("res://tests/entity/entity_samples.gd")
const NetSamples: GDScript = preload("res://tests/net/net_samples.gd")


func test_a_type_is_the_same_at_the_other_end() -> void:
	var random: RandomNumberGenerator = RandomNumberGenerator.new()
	random.seed = 2
	for number: int in 100:
		var type: EntityType = Samples.random_type(random, "type%d" % number)
		equal(type.find_fault(), "")
		var reader: ByteReader = ByteReader.new(type.encode())
		var read: EntityType = EntityType.decode(reader)
		is_true(reader.is_complete())
		is_true(read.is_same(type))


func test_damaged_types_are_refused_or_can_be_used() -> void:
	var random: RandomNumberGenerator = RandomNumberGenerator.new()
	random.seed = 3
	for _time: int in 2000:
		var bytes: PackedByteArray = Samples.random_type(random, "type").encode()
		var reader: ByteReader = ByteReader.new(NetSamples.damage(random, bytes))
		var read: EntityType = EntityType.decode(reader)
		is_true(reader.failed or read.find_fault() == "")


func test_faults_name_what_is_wrong() -> void:
	var type: EntityType = Samples.turret()
	type.fields.append(type.fields[0])
	contains(type.find_fault(), "azimuth")
	type = Samples.turret()
	type.commands.append(type.commands[0])
	contains(type.find_fault(), "aim")
	type = Samples.turret()
	type.events.append(null)
	contains(type.find_fault(), "empty")


func test_values_of_a_command_go_through_the_wire() -> void:
	var aim: EntitySchema = Samples.turret().commands[0]
	var reader: ByteReader = ByteReader.new(aim.encode([1.2345, 0.5]))
	var values: PackedFloat32Array = aim.decode(reader)
	is_true(reader.is_complete())
	almost_equal(values[0], 1.2345, 0.0006)
	almost_equal(values[1], 0.5, 0.0006)


func test_steps_out_of_range_are_no_values() -> void:
	var schema: EntitySchema = EntitySchema.create(&"x", [EntityField.create_count(&"n", 10)])
	var reader: ByteReader = ByteReader.new(PackedByteArray([11]))
	schema.decode(reader)
	is_true(reader.failed)
