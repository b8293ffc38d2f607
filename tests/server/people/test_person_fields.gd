extends TestCase
## What clients are told of people besides where their limbs are.

const FLOOR: Vector3 = Vector3(0.0, -0.5, 0.0)

var _encoder: SnapshotEncoder = SnapshotEncoder.new()
var _table: EntityTable = EntityTable.new()
var _fields: PersonFields = PersonFields.new(_encoder, _table)
var _person: ServerPerson = ServerPerson.new()
var _type: EntityType = EntityType.person()
var _tick: int = 0


func before_each() -> void:
	_encoder.configure(PackedInt32Array(Limbs.PARENTS), 0.25, 60)
	_person.ragdoll = preload("res://scenes/actor/soldier.tscn").instantiate()
	add_child(_person.ragdoll)
	_person.ragdoll.start()
	var row: EntityRow = EntityRow.new()
	row.type = _type
	_table.spawn(row)
	_person.id = row.id
	var kinds: PackedByteArray = []
	var mins: PackedFloat32Array = []
	var maxs: PackedFloat32Array = []
	var resolutions: PackedFloat32Array = []
	var values: PackedFloat32Array = []
	for field: EntityField in _type.fields:
		kinds.append(field.kind)
		mins.append(field.min_value)
		maxs.append(field.max_value)
		resolutions.append(field.resolution)
		values.append(field.default_value)
	_encoder.define_type(0, kinds, mins, maxs, resolutions)
	_encoder.add_entity(_person.id, 0, values, 1)


func test_a_body_that_is_held_back_tells_how_far() -> void:
	var wall: Block = Block.new()
	wall.size = Vector3(6.0, 4.0, 0.3)
	wall.position = Vector3(0.0, 2.0, 1.15)
	add_child(wall)
	await _walk(2.5)
	almost_equal(_field(EntityType.TETHER_Z), -1.8, 0.3)
	almost_equal(_field(EntityType.TETHER_X), 0.0, 0.1)
	await _walk(0.0)
	almost_equal(_field(EntityType.TETHER_Z), 0.0, 0.001)
	wall.free()


func test_a_frame_that_was_turned_is_told_once_it_is_at_rest() -> void:
	_fields.attach(_person, -1)
	for turn: float in [0.5, 1.0]:
		_person.ragdoll.motor.set_frame(Transform3D(Basis(Vector3.UP, turn), Vector3.ZERO))
		_look()
		almost_equal(_field(EntityType.HEADING), 0.0, 0.002)
	_look()
	almost_equal(_field(EntityType.HEADING), 1.0, 0.002)


## The motion goes there, m along Z, and stays for a moment.
func _walk(p_to: float) -> void:
	var from: float = _person.ragdoll.motor.get_root_target().z
	for step: int in 150:
		var at: Vector3 = Vector3(0.0, 1.2, lerpf(from, p_to, minf(step / 90.0, 1.0)))
		var sample: PoseSample = PoseSample.new()
		for limb: int in Limbs.COUNT:
			sample.set_orientation(limb, Quaternion.IDENTITY)
		_tick += 1
		_person.ragdoll.push_sample(_tick / 60.0, sample, at)
		_person.ragdoll.drive(_tick / 60.0, 1.0 / 60.0)
		await get_tree().physics_frame
		_fields.advance(_tick, [_person] as Array[ServerPerson])


func _look() -> void:
	_tick = (_tick / 12 + 1) * 12
	_fields.advance(_tick, [_person] as Array[ServerPerson])


func _field(p_name: StringName) -> float:
	return _encoder.get_field(_person.id, _type.find_field(p_name))


func after_each() -> void:
	_person.ragdoll.free()
