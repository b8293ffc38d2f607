@tool
class_name KitBlock
extends StaticBody3D
## Base of the blocks that levels are built of: each says of which faces and solid boxes it is made.
##
## A server keeps the solid boxes only. In a [Level] the faces of many blocks become one mesh
## ([LevelSurfaces]); elsewhere, and in the editor, a block shows itself.

## The part that every block has.
const OUTSIDE: StringName = &"outside"
## The part that is seen from above only: those of neighbours are one part.
const ROOF: StringName = &"roof"
## Group of the nodes that show the blocks below them.
const LEVEL_GROUP: StringName = &"level"
## Group of the props, [RigidBody3D] nodes: each is an entity of its own.
const PROPS_GROUP: StringName = &"props"
## Group of the cameras of other viewports that show the level too, such as that of a screen in it:
## what they see is not hidden.
const EYES_GROUP: StringName = &"level_eyes"

var _is_pending: bool = false


## What the level kit needs to know of a class of blocks; null: it is not part of the kit.
static func kit_entry() -> KitEntry:
	return null


func _init() -> void:
	collision_layer = PhysicsLayers.STATIC
	collision_mask = 0


func _ready() -> void:
	rebuild()


func _get_configuration_warnings() -> PackedStringArray:
	if not scale.is_equal_approx(Vector3.ONE):
		return ["A scaled body collides wrongly: set the scale to 1 and change the sizes instead."]
	return []


## Adds the faces and solid boxes of a part to a mesh, at the mesh's present transform.
func build(_p_mesh: BlockMesh, _p_part: StringName) -> void:
	pass


## Names of the parts, which are shown and hidden apart: what is inside a house is not seen from
## the street.
func get_parts() -> Array[StringName]:
	return [OUTSIDE]


## Key of the [ContactMaterial] of its solid boxes: how it rubs, sounds and raises dust.
func contact_key() -> StringName:
	return ContactMaterial.NO_KEY


## Whether the block is large enough to be hidden and lit apart from its neighbours.
func stands_alone() -> bool:
	return false


## Whether its faces are part of the level's meshes. Blocks with a material of their own are not.
func is_merged() -> bool:
	return true


## Lamps of the block, in its frame: see [LampLight].
func get_lamps() -> Array[LampLight]:
	return []


## A number that is the same on all machines and differs between blocks that stand elsewhere.
func seed_of_place() -> int:
	return hash(Vector3i((position * 100.0).round())) & 0x7fffffff


## Rebuilds the block before the next frame; several changes at once are one rebuild.
func queue_rebuild() -> void:
	if _is_pending or not is_inside_tree():
		return
	_is_pending = true
	rebuild.call_deferred()


## Rebuilds the block: its solid boxes, and what it shows.
func rebuild() -> void:
	_is_pending = false
	if not is_inside_tree():
		return
	# The editor would save it in every scene.
	if not Engine.is_editor_hint() and _has_kit_material():
		physics_material_override = ContactMaterial.named(contact_key())
	_remove_made()
	var mesh: BlockMesh = make_mesh(not _shows_itself())
	for part: StringName in get_parts():
		build(mesh, part)
	for index: int in mesh.get_solid_count():
		_add_solid(mesh.get_solid_place(index), mesh.get_solid_size(index))
	if mesh.get_vertex_count() > 0:
		var shown: MeshInstance3D = MeshInstance3D.new()
		shown.mesh = SurfaceMaterial.make_mesh(mesh)
		add_child(shown, false, Node.INTERNAL_MODE_BACK)
	update_configuration_warnings()


## A mesh for blocks; with solid boxes only if there is nothing to show.
static func make_mesh(p_solids_only: bool) -> BlockMesh:
	var mesh: BlockMesh = BlockMesh.new()
	mesh.set_layer_edges(PackedFloat32Array(SurfaceLayers.EDGE_M))
	mesh.set_solids_only(p_solids_only)
	mesh.set_dust(0.0, 0.0)
	return mesh


func _has_kit_material() -> bool:
	return physics_material_override == null or physics_material_override is ContactMaterial


func _shows_itself() -> bool:
	if DisplayServer.get_name() == "headless" or not is_merged():
		return false
	return Engine.is_editor_hint() or not _is_in_level()


func _is_in_level() -> bool:
	var node: Node = get_parent()
	while node != null:
		if node.is_in_group(LEVEL_GROUP):
			return true
		node = node.get_parent()
	return false


func _add_solid(p_place: Transform3D, p_size: Vector3) -> void:
	var box: BoxShape3D = BoxShape3D.new()
	box.size = p_size
	var shape: CollisionShape3D = CollisionShape3D.new()
	shape.shape = box
	shape.transform = p_place
	add_child(shape, false, Node.INTERNAL_MODE_BACK)


func _remove_made() -> void:
	var others: Array[Node] = get_children()
	for child: Node in get_children(true):
		if not others.has(child):
			child.free()
