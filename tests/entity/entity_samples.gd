extends RefCounted
## Entity types and rows for tests, also random ones.


## A type with fields of every kind, a command and two events.
static func turret(p_body: EntityType.Body = EntityType.Body.NONE) -> EntityType:
	var type: EntityType = EntityType.new()
	type.name = &"turret"
	type.body = p_body
	type.commanded_by = EntityType.CommandedBy.POSSESSOR
	type.fields = [
		EntityField.create(&"azimuth", EntityField.Kind.ANGLE, -PI, PI, 0.001),
		EntityField.create(&"elevation", EntityField.Kind.LINEAR, -0.2, 1.0, 0.001, 0.1),
		EntityField.create_count(&"rounds", 40, 40),
	]
	var aim: Array[EntityField] = [type.fields[0], type.fields[1]]
	type.commands = [EntitySchema.create(&"aim", aim), EntitySchema.create(&"fire")]
	type.events = [EntitySchema.create(&"fired", [], false), EntitySchema.create(&"empty")]
	return type


## A row for a type.
static func row(p_type: EntityType, p_path: String = "") -> EntityRow:
	var made: EntityRow = EntityRow.new()
	made.type = p_type
	made.path = p_path
	made.source = EntityRow.Source.LEVEL if p_path != "" else EntityRow.Source.NONE
	return made


## A random type that can be used.
static func random_type(p_random: RandomNumberGenerator, p_name: String) -> EntityType:
	var type: EntityType = EntityType.new()
	type.name = p_name
	type.body = p_random.randi_range(0, EntityType.Body.size() - 1) as EntityType.Body
	for index: int in p_random.randi_range(0, EntitySchema.MAX_FIELDS):
		type.fields.append(random_field(p_random, "field%d" % index))
	for index: int in p_random.randi_range(0, 4):
		var fields: Array[EntityField] = [random_field(p_random, "value")]
		type.commands.append(EntitySchema.create("command%d" % index, fields))
		type.events.append(EntitySchema.create("event%d" % index, fields, p_random.randf() < 0.5))
	return type


## A random field that can be used.
static func random_field(p_random: RandomNumberGenerator, p_name: String) -> EntityField:
	var low: float = p_random.randf_range(-1000.0, 1000.0)
	var steps: int = p_random.randi_range(2, 1 << p_random.randi_range(2, 23))
	var resolution: float = p_random.randf_range(0.0001, 1.0)
	var kind: EntityField.Kind = p_random.randi_range(0, 2) as EntityField.Kind
	return EntityField.create(p_name, kind, low, low + steps * resolution, resolution, low)
