class_name ServerImpacts
extends RefCounted
## Finds which bodies strike each other in the world, for the sounds at clients: things, vehicles
## and people.
##
## Feet are left out: clients hear steps where they see feet touch the ground.

## Most impacts and scrapes in a second, and at once.
const RATE: float = 200.0
const BURST: float = 60.0
## Groups of bodies that make no sound among themselves begin with it: 0 is none.
const _FIRST_GROUP: int = 1

var _watch: ImpactWatch = ImpactWatch.new()
## Numbers of the contact materials of entities.
var _materials: Dictionary[int, int] = {}
var _left: float = BURST


func _init(p_level: ServerLevel, p_people: ServerPeople) -> void:
	p_level.entity_added.connect(_on_entity_added)
	p_level.table.despawned.connect(_on_despawned)
	p_people.person_added.connect(_on_person_added)


## Impacts and scrapes of the last step as a message; empty bytes for none. Call it once a tick,
## with its length, s.
func take_message(p_tick: int, p_delta_s: float) -> PackedByteArray:
	_left = minf(_left + RATE * p_delta_s, BURST)
	var impacts: Array[Impact] = []
	for index: int in mini(_watch.advance(), floori(_left)):
		impacts.append(_describe(index))
	_left -= impacts.size()
	return ImpactMessage.encode(p_tick, impacts) if not impacts.is_empty() else PackedByteArray()


func _describe(p_index: int) -> Impact:
	var impact: Impact = Impact.new()
	impact.entity = _watch.get_entity(p_index)
	impact.place = _watch.get_place(p_index)
	impact.impulse = _watch.get_impulse(p_index)
	impact.slip = _watch.get_slip(p_index)
	impact.material = _materials.get(impact.entity, 0)
	var other: int = _watch.get_other_entity(p_index)
	if other >= 0:
		impact.other = other
		impact.other_material = _materials.get(other, 0)
	else:
		var struck: Object = instance_from_id(_watch.get_other_instance(p_index))
		impact.other_material = ContactMaterial.number_of(
			ContactMaterial.at(struck, impact.place).key
		)
	return impact


func _on_entity_added(p_row: EntityRow, _node: Entity, p_body: PhysicsBody3D) -> void:
	# What only a script moves strikes nothing by itself.
	if p_body is not RigidBody3D:
		return
	var key: StringName = &"metal" if p_body is Vehicle else ContactMaterial.key_of(p_body)
	_materials[p_row.id] = ContactMaterial.number_of(key)
	_watch.watch(p_row.id, p_body.get_rid())


func _on_person_added(p_person: ServerPerson) -> void:
	_materials[p_person.id] = ContactMaterial.number_of(ContactMaterial.PERSON)
	var order: PackedInt32Array = p_person.ragdoll.get_limb_order()
	for limb: int in Limbs.COUNT:
		if limb not in Limbs.FEET:
			var body: RID = p_person.ragdoll.get_bodies()[order[limb]]
			_watch.watch(p_person.id, body, _FIRST_GROUP + p_person.id)


func _on_despawned(p_row: EntityRow) -> void:
	if _materials.erase(p_row.id):
		_watch.forget(p_row.id)
