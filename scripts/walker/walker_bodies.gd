class_name WalkerBodies
extends RefCounted
## The bodies of a level as walkers meet them: which carry, which are ladders, and which are so
## light that a person pushes them. Server and client find the same ones.

## Loose bodies below this weight are passed through by movers: there the person's own body, which
## follows, pushes and is held back, kg.
const LIGHT_KG: float = 60.0

var _bodies: Dictionary[int, PhysicsBody3D] = {}
var _ladders: Array[RID] = []
var _movers: Array[WalkerMover] = []


## Puts a mover into a world, and tells it of the bodies that there are and will be.
func add_mover(p_mover: WalkerMover, p_world: World3D) -> void:
	p_mover.enter(p_world.space, p_world, PhysicsLayers.STATIC | PhysicsLayers.PROPS)
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


## The body of an entity, by its number.
func add_body(p_entity: int, p_body: PhysicsBody3D) -> void:
	_bodies[p_entity] = p_body
	for mover: WalkerMover in _movers:
		_tell(mover, p_entity)


## Where the body of an entity is in the world; nowhere else than at the origin if there is none.
func transform_of(p_entity: int) -> Transform3D:
	var body: PhysicsBody3D = _bodies.get(p_entity)
	return body.global_transform if is_instance_valid(body) else Transform3D.IDENTITY


func _tell_all(p_mover: WalkerMover) -> void:
	for ladder: RID in _ladders:
		p_mover.set_ladder(ladder, true)
	for id: int in _bodies:
		_tell(p_mover, id)


func _tell(p_mover: WalkerMover, p_entity: int) -> void:
	var body: PhysicsBody3D = _bodies[p_entity]
	if not is_instance_valid(body):
		return
	var loose: RigidBody3D = body as RigidBody3D
	if loose != null and loose.mass < LIGHT_KG:
		p_mover.set_passable(body.get_rid(), true)
	elif not body is StaticBody3D or body is AnimatableBody3D:
		p_mover.set_carrier(body.get_rid(), p_entity)
