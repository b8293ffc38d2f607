@tool
@icon("res://scenes/world/icons/trigger_zone.svg")
class_name TriggerZone
extends Area3D
## A part of a level that notices who comes and who goes: people, or things.
##
## It stands on its origin. The server decides; at the server and at every client, in a replay too,
## [signal entered] and [signal left] say who it was, and screens show it. How many are inside are
## fields of its entity. No script is needed; one that listens can open a door or count.

## Somebody or something has come in: the number of the entity, and what people call it.
signal entered(p_entity: int, p_name: String)
## Somebody or something has gone out.
signal left(p_entity: int, p_name: String)
## The text that screens show when somebody or something comes or goes.
signal notified(p_text: String)

## What shape it has.
enum Form {
	## Edges along the axes of the node.
	BOX,
	## Upright and round.
	CYLINDER,
}

## Whom it notices.
enum Notices {
	## People, whose hips count.
	PEOPLE = 1,
	## Props and other bodies that move.
	THINGS = 2,
}

## Name of its entity's type.
const TYPE: StringName = &"trigger_zone"
## Fields: how many people and things are inside.
const PEOPLE_INSIDE: StringName = &"people"
const THINGS_INSIDE: StringName = &"things"
## Events, with the number of the entity.
const ENTERED: StringName = &"entered"
const LEFT: StringName = &"left"
## The bone whose body counts as the person.
const BONE: StringName = &"Hips"
## Smallest edge, m.
const MIN_M: float = 0.1
## Ticks between two searches for the entity of a body that has none yet.
const AGAIN_TICKS: int = 6
## Greatest count of people, and of things.
const MAX_INSIDE: int = 4095

static var _type: EntityType = null

## What people call it; empty: the name of the node.
@export var title: String = ""
## What shape it has.
@export var form: Form = Form.BOX:
	set(p_value):
		form = p_value
		_rebuild()
## Width, height and depth; of a cylinder the width is the diameter.
@export_custom(PROPERTY_HINT_NONE, "suffix:m") var size: Vector3 = Vector3(3.0, 2.2, 3.0):
	set(p_value):
		size = p_value.max(Vector3.ONE * MIN_M)
		_rebuild()
## Whom it notices.
@export_flags("People:1", "Things:2") var notices: int = Notices.PEOPLE:
	set(p_value):
		notices = p_value
		_set_mask()
		update_configuration_warnings()
## Whether screens show who comes and goes.
@export var is_told: bool = true

var _shape: CollisionShape3D = CollisionShape3D.new()
var _entity: Entity = Entity.new()
# Entities that are inside, by their bodies.
var _inside: Dictionary[Node3D, int] = {}
# Their names.
var _names: Dictionary[int, String] = {}
# Bodies inside that are nobody's: a person's come some ticks before the person.
var _strangers: Array[Node3D] = []


func _init() -> void:
	collision_layer = 0
	monitorable = false
	_shape.name = "Shape"
	add_child(_shape, false, Node.INTERNAL_MODE_FRONT)
	_entity.name = "Entity"
	_entity.type = _make_type()
	add_child(_entity, false, Node.INTERNAL_MODE_FRONT)
	_set_mask()
	_rebuild()


func _ready() -> void:
	set_physics_process(false)
	if Engine.is_editor_hint():
		return
	body_entered.connect(_on_body_entered)
	body_exited.connect(_on_body_exited)
	_entity.happened.connect(_on_happened)
	_entity.started.connect(_look)


func _get_configuration_warnings() -> PackedStringArray:
	var warnings: PackedStringArray = []
	if not scale.is_equal_approx(Vector3.ONE):
		warnings.append("A scaled zone has another size than it shows: set the scale to 1.")
	if notices == 0:
		warnings.append("It notices nothing: switch on People or Things at 'Notices'.")
	return warnings


func _physics_process(_delta: float) -> void:
	if Engine.get_physics_frames() % AGAIN_TICKS == 0:
		_strangers = _strangers.filter(func(body: Node3D) -> bool: return not _take(body))
		set_physics_process(not _strangers.is_empty())


## What people call it.
func get_title() -> String:
	return title if title != "" else String(name).capitalize()


## How many people are inside.
func count_people() -> int:
	return roundi(_entity.get_value(PEOPLE_INSIDE)) if _entity.is_started() else 0


## How many things are inside.
func count_things() -> int:
	return roundi(_entity.get_value(THINGS_INSIDE)) if _entity.is_started() else 0


## Its box in its own frame.
func get_box() -> AABB:
	var depth: float = size.z if form == Form.BOX else size.x
	return AABB(Vector3(-size.x / 2.0, 0.0, -depth / 2.0), Vector3(size.x, size.y, depth))


func _rebuild() -> void:
	if form == Form.BOX:
		var box: BoxShape3D = BoxShape3D.new()
		box.size = size
		_shape.shape = box
	else:
		var cylinder: CylinderShape3D = CylinderShape3D.new()
		cylinder.radius = size.x / 2.0
		cylinder.height = size.y
		_shape.shape = cylinder
	_shape.position = Vector3.UP * size.y / 2.0
	update_gizmos()


func _set_mask() -> void:
	collision_mask = PhysicsLayers.PEOPLE if notices & Notices.PEOPLE else 0
	collision_mask |= PhysicsLayers.PROPS if notices & Notices.THINGS else 0


# Bodies that were inside before it became part of a session.
func _look() -> void:
	_inside.clear()
	_strangers.clear()
	if is_inside_tree() and _entity.is_authority():
		for body: Node3D in get_overlapping_bodies():
			_on_body_entered(body)


func _on_body_entered(p_body: Node3D) -> void:
	if not _entity.is_authority() or _inside.has(p_body):
		return
	var bone: PhysicalBone3D = p_body as PhysicalBone3D
	if bone != null and bone.bone_name != BONE:
		return
	if not _take(p_body):
		_strangers.append(p_body)
		set_physics_process(true)


## Whether it is known whose body it is.
func _take(p_body: Node3D) -> bool:
	var id: int = _entity.get_authority().find_by_body(p_body)
	if id < 0 or _inside.size() >= MAX_INSIDE:
		return false
	_inside[p_body] = id
	_tell(p_body, ENTERED, 1)
	return true


func _on_body_exited(p_body: Node3D) -> void:
	_strangers.erase(p_body)
	if not _inside.has(p_body):
		return
	# A level that goes takes its zones with it.
	if _entity.get_host().name_of(_entity.id) != "":
		_tell(p_body, LEFT, -1)
	_inside.erase(p_body)


func _tell(p_body: Node3D, p_event: StringName, p_step: int) -> void:
	var field: StringName = PEOPLE_INSIDE if p_body is PhysicalBone3D else THINGS_INSIDE
	_entity.set_value(field, _entity.get_value(field) + p_step)
	_entity.send_event(p_event, [_inside[p_body]])


func _on_happened(p_event: StringName, p_values: PackedFloat32Array) -> void:
	var id: int = roundi(p_values[0])
	var who: String = _entity.get_host().name_of(id)
	# Who leaves the session leaves the zone, and is not in the table any more.
	who = _names.get(id, "somebody") if who == "" else who
	_names[id] = who
	if p_event == LEFT:
		_names.erase(id)
	(entered if p_event == ENTERED else left).emit(id, who)
	if is_told:
		var text: String = "%s %s %s" % [who, p_event, get_title()]
		Log.info("world", text)
		notified.emit(text)


static func _make_type() -> EntityType:
	if _type == null:
		_type = EntityType.new()
		_type.name = TYPE
		_type.fields = [
			EntityField.create_count(PEOPLE_INSIDE, MAX_INSIDE),
			EntityField.create_count(THINGS_INSIDE, MAX_INSIDE),
		]
		for event: StringName in [ENTERED, LEFT]:
			var who: EntityField = EntityField.create_count(&"who", 65535)
			_type.events.append(EntitySchema.create(event, [who] as Array[EntityField]))
	return _type
