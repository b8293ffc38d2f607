@tool
@icon("res://scenes/world/icons/door.svg")
class_name Door
extends RigidBody3D
## A door on a hinge that people push open with their bodies; both ways, if it may.
##
## It is a prop: the server simulates it and everybody sees it swing. Its origin is the lower end of
## the hinge; shut, its leaf goes along +X and its front looks to +Z. It does not touch what never
## moves, so it needs no gap in its frame, and stops at its widest angle.

## To which side a door opens.
enum Way {
	## Towards where its front looks.
	OUT,
	IN,
	BOTH,
}

## Thickness of the leaf, m.
const THICK_M: float = 0.05
## The widest angle at which it stops, degrees: then its leaf is along the side of the opening.
const MAX_DEG: float = 170.0
## Free space above and below the leaf, m.
const GAP_M: float = 0.015
## Distance from which on the leaf is not drawn, m.
const SHOWN_M: float = 45.0

## Meshes of leaves that look alike: many doors share one.
static var _meshes: Dictionary[String, ArrayMesh] = {}

## Width and height of the leaf.
@export_custom(PROPERTY_HINT_NONE, "suffix:m") var size: Vector2 = Vector2(0.98, 2.08):
	set(p_value):
		size = p_value.clamp(Vector2(0.3, 0.5), Vector2(4.0, 5.0))
		_queue_rebuild()
## To which side people can push it.
@export var opens: Way = Way.BOTH:
	set(p_value):
		opens = clampi(p_value, 0, Way.BOTH) as Way
		_queue_rebuild()
## The hinge is at its right instead, seen from its front: the leaf goes along -X.
@export var right_hinge: bool = false:
	set(p_value):
		right_hinge = p_value
		_queue_rebuild()
## How wide it opens. Beyond 88 degrees it swings through the wall beside it, if the wall is thick.
@export_range(10.0, 170.0, 1.0, "suffix:°") var widest: float = 88.0:
	set(p_value):
		widest = clampf(p_value, 10.0, MAX_DEG)
		_queue_rebuild()
## How far it stands open at the start; negative is outwards.
@export_range(-170.0, 170.0, 1.0, "suffix:°") var ajar: float = 0.0:
	set(p_value):
		ajar = clampf(p_value, -MAX_DEG, MAX_DEG)
		_queue_rebuild()
## How fast it comes to rest: part of its speed that it loses in a second.
@export_range(0.1, 10.0, 0.1) var friction: float = 1.8:
	set(p_value):
		friction = clampf(p_value, 0.1, 10.0)
		angular_damp = friction
## What its leaf is made of.
@export var layer: SurfaceLayers.Layer = SurfaceLayers.Layer.PAINTED_WOOD:
	set(p_value):
		layer = clampi(p_value, 0, SurfaceLayers.Layer.size() - 1) as SurfaceLayers.Layer
		physics_material_override = ContactMaterial.find(SurfaceLayers.key_of(layer))
		_queue_rebuild()
## Colour of the leaf.
@export var tint: SurfaceTints.Tint = SurfaceTints.Tint.TRIM_BROWN:
	set(p_value):
		tint = clampi(p_value, 0, SurfaceTints.Tint.size() - 1) as SurfaceTints.Tint
		_queue_rebuild()

var _is_pending: bool = false
## Its transform when shut.
var _shut: Transform3D = Transform3D.IDENTITY
## Shape, leaf and hinge.
var _made: Array[Node] = []


func _init() -> void:
	collision_layer = PhysicsLayers.PROPS
	collision_mask = PhysicsLayers.PEOPLE | PhysicsLayers.PROPS
	mass = 18.0
	angular_damp = friction
	physics_material_override = ContactMaterial.find(SurfaceLayers.key_of(layer))
	add_to_group(KitBlock.PROPS_GROUP)


func _ready() -> void:
	rebuild()


func _get_configuration_warnings() -> PackedStringArray:
	var warnings: PackedStringArray = []
	if not scale.is_equal_approx(Vector3.ONE):
		warnings.append("A scaled body collides wrongly: set the scale to 1 and change the size.")
	if not global_basis.y.normalized().is_equal_approx(Vector3.UP):
		warnings.append("Its hinge is not upright: it would swing by its weight. Set X and Z to 0.")
	if ajar < limits().x or ajar > limits().y:
		warnings.append("It cannot stand that far open: change 'Ajar', 'Opens' or 'Widest'.")
	return warnings


## The least and the greatest angle by which it can be open, degrees; inwards is positive.
func limits() -> Vector2:
	return Vector2(
		0.0 if opens == Way.IN else -widest,
		0.0 if opens == Way.OUT else widest,
	)


## By which angle it is open now, degrees; inwards is positive.
func angle() -> float:
	var way: Vector3 = _shut.basis.inverse() * transform.basis.x
	var inwards: float = rad_to_deg(atan2(-way.z, way.x))
	return -inwards if right_hinge else inwards


## Rebuilds the leaf, and outside the editor the hinge, from where the door stands now.
func rebuild() -> void:
	_is_pending = false
	if not is_inside_tree():
		return
	for child: Node in _made:
		child.free()
	_made.clear()
	_add_shape()
	if DisplayServer.get_name() != "headless":
		_add_leaf()
	if not Engine.is_editor_hint():
		_hang()
	update_configuration_warnings()


## Joins it to the world where it is shut, then opens it as far as it shall stand open.
func _hang() -> void:
	_shut = transform
	var hinge: HingeJoint3D = HingeJoint3D.new()
	# A hinge turns about its Z.
	hinge.rotation.x = -PI / 2.0
	hinge.node_a = NodePath("..")
	hinge.set_flag(HingeJoint3D.FLAG_USE_LIMIT, true)
	# The engine turns the world against the leaf.
	var range_deg: Vector2 = limits()
	if not right_hinge:
		range_deg = Vector2(-range_deg.y, -range_deg.x)
	hinge.set_param(HingeJoint3D.PARAM_LIMIT_LOWER, deg_to_rad(range_deg.x))
	hinge.set_param(HingeJoint3D.PARAM_LIMIT_UPPER, deg_to_rad(range_deg.y))
	_keep(hinge)
	var open_deg: float = clampf(ajar, limits().x, limits().y)
	rotate_object_local(Vector3.UP, deg_to_rad(-open_deg if right_hinge else open_deg))


func _add_shape() -> void:
	var box: BoxShape3D = BoxShape3D.new()
	box.size = Vector3(size.x, size.y - 2.0 * GAP_M, THICK_M)
	var shape: CollisionShape3D = CollisionShape3D.new()
	shape.shape = box
	shape.position = Vector3(size.x * (-0.5 if right_hinge else 0.5), size.y * 0.5, 0.0)
	_keep(shape)


func _add_leaf() -> void:
	var leaf: MeshInstance3D = MeshInstance3D.new()
	leaf.mesh = _mesh_of(size, layer, tint)
	if right_hinge:
		leaf.rotation.y = PI
	if Engine.is_editor_hint():
		leaf.rotation.y += deg_to_rad(-ajar if right_hinge else ajar)
	leaf.visibility_range_end = SHOWN_M
	leaf.visibility_range_end_margin = SHOWN_M * 0.1
	_keep(leaf)


func _keep(p_node: Node) -> void:
	_made.append(p_node)
	add_child(p_node, false, Node.INTERNAL_MODE_BACK)


func _queue_rebuild() -> void:
	if _is_pending or not is_inside_tree():
		return
	_is_pending = true
	rebuild.call_deferred()


## The leaf, its boards and a handle on both sides.
static func _mesh_of(p_size: Vector2, p_layer: int, p_tint: int) -> ArrayMesh:
	var key: String = "%s %d %d" % [p_size, p_layer, p_tint]
	if not _meshes.has(key):
		var blocks: BlockMesh = KitBlock.make_mesh(false)
		var half: float = THICK_M / 2.0
		blocks.box(
			Vector3(0.0, GAP_M, -half * 0.6),
			Vector3(p_size.x, p_size.y - GAP_M, half * 0.6),
			p_layer,
			p_tint
		)
		for share: float in [0.02, 0.46, 0.88]:
			var y: float = GAP_M + p_size.y * share
			blocks.box(
				Vector3(0.03, y, -half), Vector3(p_size.x - 0.03, y + 0.16, half), p_layer, p_tint
			)
		var grip: float = p_size.x - 0.09
		for side: float in [-1.0, 1.0]:
			var near: Vector3 = Vector3(grip - 0.1, 1.0, side * half)
			var far: Vector3 = Vector3(grip, 1.03, side * (half + 0.04))
			blocks.box(
				near.min(far), near.max(far), SurfaceLayers.Layer.STEEL, SurfaceTints.Tint.IRON
			)
		_meshes[key] = PropMesh.make(blocks)
	return _meshes[key]
