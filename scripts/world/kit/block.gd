@tool
@icon("res://scenes/world/icons/block.svg")
class_name Block
extends KitBlock
## A box of the static world: a floor, a wall, a platform. It makes its own mesh and collision
## shape.

## Edge lengths.
@export_custom(PROPERTY_HINT_NONE, "suffix:m") var size: Vector3 = Vector3.ONE:
	set(value):
		size = value.max(Vector3.ONE * 0.01)
		rebuild()
## What it is made of.
@export var surface: SurfaceLayers.Layer = SurfaceLayers.Layer.CONCRETE:
	set(value):
		surface = value
		rebuild()
## Its colour.
@export var tint: SurfaceTints.Tint = SurfaceTints.Tint.PLAIN:
	set(value):
		tint = value
		rebuild()
## A material of its own instead; such a block is drawn by itself and gets no baked light.
@export var material: Material:
	set(value):
		material = value
		rebuild()


static func kit_entry() -> KitEntry:
	var entry: KitEntry = KitEntry.of_block(
		Block,
		20000,
		{
			"size": PropertyRule.vector3(0.01, 2000.0),
			"material": PropertyRule.resource(KitClass.MATERIALS)
		}
	)
	entry.offered("Floor", "block ground plate", {&"size": Vector3(4, 0.2, 4)}, 0.1)
	entry.offered("Block", "box cube", {}, 0.5)
	entry.offered("Platform", "block step", {&"size": Vector3(2, 1, 2)}, 0.5)
	return entry


func contact_key() -> StringName:
	return SurfaceLayers.key_of(surface)


func build(p_mesh: BlockMesh, _p_part: StringName) -> void:
	p_mesh.box(size * -0.5, size * 0.5, surface, tint, 0, true)


func is_merged() -> bool:
	return material == null


func rebuild() -> void:
	super()
	if material != null and is_inside_tree():
		add_child(make_plain_box(size, material), false, Node.INTERNAL_MODE_BACK)


## A box that is only seen, with a material of its own.
static func make_plain_box(p_size: Vector3, p_material: Material) -> MeshInstance3D:
	var mesh: BoxMesh = BoxMesh.new()
	mesh.size = p_size
	mesh.material = p_material
	var shown: MeshInstance3D = MeshInstance3D.new()
	shown.mesh = mesh
	return shown
