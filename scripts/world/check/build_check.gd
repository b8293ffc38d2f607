class_name BuildCheck
extends RefCounted
## Whether a level's things are solid, not scaled and not too many, and whether its light is baked.

## Most bodies that move. The server's tick has room for 200 crates and eight people on two cores;
## bodies at rest cost little.
const MAX_BODIES: int = 400
## The smallest thing that looks solid, m.
const SOLID_M: float = 0.6

var _findings: LevelFindings = null
var _level: Level = null


func _init(p_findings: LevelFindings) -> void:
	_findings = p_findings
	_level = p_findings.level


## Does the work.
func run() -> void:
	var moving: int = 0
	for node: Node in _level.find_children("*", "CollisionObject3D", true, false):
		var body: PhysicsBody3D = node as PhysicsBody3D
		if body == null:
			continue
		if body is RigidBody3D:
			moving += 1
		_look_at_body(body)
	if moving > MAX_BODIES:
		var text: String = "%d bodies move, the tick has room for about %d: take some away, or make "
		_findings.add_fault(
			LevelFault.Kind.TOO_MANY_BODIES,
			null,
			text % [moving, MAX_BODIES] + "those that never move StaticBody3D nodes or blocks"
		)
	_look_at_meshes()
	_look_at_light()


func _look_at_body(p_body: PhysicsBody3D) -> void:
	# Some blocks are only seen, such as wires; so is what is on no layer.
	if p_body is not KitBlock and p_body.collision_layer != 0 and not _has_shape(p_body):
		var advice: String = "people and things go through it: add a CollisionShape3D, or switch "
		advice += "off its collision layers if it is only to be seen"
		_findings.add_fault(LevelFault.Kind.NO_COLLISION, p_body, advice)
	if p_body.global_basis.get_scale().is_equal_approx(Vector3.ONE):
		return
	var cause: Node3D = p_body
	while cause != _level and cause.scale.is_equal_approx(Vector3.ONE):
		var above: Node3D = cause.get_parent() as Node3D
		if above == null:
			break
		cause = above
	var scale: Vector3 = cause.scale
	var text: String = "it is scaled by (%.2f, %.2f, %.2f)" % [scale.x, scale.y, scale.z]
	if cause != p_body:
		text += " through '%s'" % cause.name
	text += ", bodies then collide wrongly: set that scale to 1 and change the sizes instead"
	_findings.add_fault(LevelFault.Kind.SCALED, p_body, text)


static func _has_shape(p_body: CollisionObject3D) -> bool:
	for owner: int in p_body.get_shape_owners():
		if (
			not p_body.is_shape_owner_disabled(owner)
			and p_body.shape_owner_get_shape_count(owner) > 0
		):
			return true
	return false


## Meshes that stand among what never moves and belong to no body.
func _look_at_meshes() -> void:
	if _level.static_root == null:
		return
	for node: Node in _level.static_root.find_children("*", "MeshInstance3D", true, false):
		var shown: MeshInstance3D = node as MeshInstance3D
		var size: Vector3 = (shown.global_transform * shown.get_aabb()).size
		if size[size.min_axis_index()] < SOLID_M or _is_in_body(shown):
			continue
		_findings.add_hint(
			LevelFault.Kind.NO_COLLISION,
			shown,
			"it is seen but not solid: put it below a StaticBody3D with a CollisionShape3D"
		)


func _is_in_body(p_node: Node) -> bool:
	var node: Node = p_node
	while node != null and node != _level:
		if node is CollisionObject3D:
			return true
		# Beside the body, or with it as a child: scenes are made both ways.
		if not node.find_children("*", "CollisionObject3D", false, false).is_empty():
			return true
		node = node.get_parent()
		if node == _level.static_root:
			break
	return false


func _look_at_light() -> void:
	var parts: Array[SurfacePart] = SurfacePart.gather(_level)
	if parts.is_empty() or _level.scene_file_path == "":
		return
	var path: String = _level.bake_path
	if path == "":
		path = Level.bake_path_of(_level.scene_file_path)
	if not FileAccess.file_exists(path):
		_findings.add_hint(
			LevelFault.Kind.NOT_BAKED,
			null,
			"its light is not baked, rooms are too bright: Bake level"
		)
		return
	var bake: LevelBake = LevelBake.load_file(path)
	if bake.error != "":
		_findings.add_fault(LevelFault.Kind.NOT_BAKED, null, bake.error + ": Bake level")
	elif bake.source_hash != LevelBake.hash_of(parts):
		_findings.add_hint(
			LevelFault.Kind.NOT_BAKED,
			null,
			"blocks have changed since its light was baked: Bake level"
		)
