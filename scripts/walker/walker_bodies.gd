class_name WalkerBodies
extends RefCounted
## The bodies of a level as walkers meet them: which carry, which are ladders, and which are so
## light that a person pushes them. Server and client find the same ones.

## Loose bodies below this weight are passed through by movers: there the person's own body, which
## follows, pushes and is held back, kg.
const LIGHT_KG: float = 60.0

## What stops a walker, and what it stands on: layers.
const MASK: int = PhysicsLayers.STATIC | PhysicsLayers.PROPS
## How far below hips ground is looked for, m.
const _REACH_M: float = 2.0

var _bodies: Dictionary[int, PhysicsBody3D] = {}
var _ladders: Array[RID] = []
var _movers: Array[WalkerMover] = []


## Puts a mover into a world, and tells it of the bodies that there are and will be.
func add_mover(p_mover: WalkerMover, p_world: World3D) -> void:
	p_mover.enter(p_world.space, p_world, MASK)
	_movers.append(p_mover)
	_tell_all(p_mover)


## Forgets a mover.
func remove_mover(p_mover: WalkerMover) -> void:
	_movers.erase(p_mover)


## Another level: its ladders, and none of what is gone with the last one.
func set_level(p_level: Level) -> void:
	_ladders.clear()
	for node: Node in p_level.find_children("*", "StaticBody3D", true, false):
		if node is Ladder:
			_ladders.append((node as Ladder).get_rid())
	for id: int in _bodies.keys():
		if not is_instance_valid(_bodies[id]):
			_bodies.erase(id)
	for mover: WalkerMover in _movers:
		mover.clear_bodies()
		_tell_all(mover)


## An entity of the level has come: takes its body, if it has one that is no person's.
func add_entity(p_row: EntityRow, _node: Entity, p_body: PhysicsBody3D) -> void:
	if p_body != null and not p_row.is_person():
		add_body(p_row.id, p_body)


## The body of an entity, by its number.
func add_body(p_entity: int, p_body: PhysicsBody3D) -> void:
	_bodies[p_entity] = p_body
	for mover: WalkerMover in _movers:
		_tell(mover, p_entity)


## Where the body of an entity is in the world; nowhere else than at the origin if there is none.
func transform_of(p_entity: int) -> Transform3D:
	if not is_instance_valid(_bodies.get(p_entity)):
		return Transform3D.IDENTITY
	return _bodies[p_entity].global_transform


## The ground below hips, m; where there is none, another place.
static func find_ground(p_world: World3D, p_hips: Vector3, p_otherwise: Vector3) -> Vector3:
	var ray: PhysicsRayQueryParameters3D = PhysicsRayQueryParameters3D.create(
		p_hips, p_hips + Vector3.DOWN * _REACH_M, MASK
	)
	var hit: Dictionary = p_world.direct_space_state.intersect_ray(ray)
	return hit["position"] if not hit.is_empty() else p_otherwise


func _tell_all(p_mover: WalkerMover) -> void:
	for ladder: RID in _ladders:
		p_mover.set_ladder(ladder, true)
	for id: int in _bodies:
		_tell(p_mover, id)


func _tell(p_mover: WalkerMover, p_entity: int) -> void:
	# One that a script has freed must not even be named.
	if not is_instance_valid(_bodies[p_entity]):
		return
	var body: PhysicsBody3D = _bodies[p_entity]
	var loose: RigidBody3D = body as RigidBody3D
	if loose != null and loose.mass < LIGHT_KG:
		p_mover.set_passable(body.get_rid(), true)
	elif not body is StaticBody3D or body is AnimatableBody3D:
		p_mover.set_carrier(body.get_rid(), p_entity)
