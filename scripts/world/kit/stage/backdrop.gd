@tool
@icon("res://scenes/world/icons/backdrop.svg")
class_name Backdrop
extends KitBlock
## A printed cloth that hangs behind a stage in shallow folds; its origin is the middle of its foot,
## its picture is seen from +Z. It has a material of its own, and takes its light from the air.

const _SHADER: String = "res://assets/shaders/backdrop.gdshader"
## The picture of a new one: loaded by who has a backdrop, not by all who know the class.
const _PICTURE: String = "res://assets/world/backdrops/dunes.jpg"

## What is printed on it; without a picture it is plain.
@export var picture: Texture2D = null:
	set(p_value):
		picture = p_value
		queue_rebuild()
## Width and height.
@export_custom(PROPERTY_HINT_NONE, "suffix:m") var size: Vector2 = Vector2(12.0, 6.0):
	set(p_value):
		size = p_value.clamp(Vector2(0.5, 0.5), Vector2(60.0, 30.0))
		queue_rebuild()
## Width of a fold.
@export_range(0.2, 3.0, 0.05, "suffix:m") var fold: float = 0.9:
	set(p_value):
		fold = clampf(p_value, 0.2, 3.0)
		queue_rebuild()
## How far folds stand out.
@export_range(0.0, 0.5, 0.01, "suffix:m") var depth: float = 0.05:
	set(p_value):
		depth = clampf(p_value, 0.0, 0.5)
		queue_rebuild()


static func kit_entry() -> KitEntry:
	var entry: KitEntry = KitEntry.of_block(
		Backdrop,
		20,
		{
			"picture": PropertyRule.resource(["Texture2D", "CompressedTexture2D"]),
			"size": PropertyRule.vector2(0.5, 60.0)
		}
	)
	entry.offered("Backdrop", "cloth picture")
	return entry


func _init() -> void:
	super()
	picture = load(_PICTURE) as Texture2D


func _get_configuration_warnings() -> PackedStringArray:
	var warnings: PackedStringArray = super()
	if picture == null:
		warnings.append("It is plain: choose a picture of assets/world/backdrops for 'Picture'.")
	return warnings


func contact_key() -> StringName:
	return &"cloth"


func build(p_mesh: BlockMesh, _p_part: StringName) -> void:
	var half: float = maxf(depth, 0.03)
	p_mesh.solid(Vector3(-size.x / 2.0, 0.0, -half), Vector3(size.x / 2.0, size.y, half))


func is_merged() -> bool:
	return false


func rebuild() -> void:
	super()
	if not is_inside_tree() or DisplayServer.get_name() == "headless":
		return
	var cloth: Drapery = Drapery.new(size, fold, depth)
	var arrays: Array = []
	arrays.resize(Mesh.ARRAY_MAX)
	arrays[Mesh.ARRAY_VERTEX] = cloth.points
	arrays[Mesh.ARRAY_NORMAL] = cloth.normals
	arrays[Mesh.ARRAY_TEX_UV] = cloth.uvs
	arrays[Mesh.ARRAY_INDEX] = cloth.indices
	var mesh: ArrayMesh = ArrayMesh.new()
	mesh.add_surface_from_arrays(Mesh.PRIMITIVE_TRIANGLES, arrays)
	var material: ShaderMaterial = ShaderMaterial.new()
	material.shader = load(_SHADER)
	material.set_shader_parameter(&"picture", picture)
	mesh.surface_set_material(0, material)
	var shown: MeshInstance3D = MeshInstance3D.new()
	shown.mesh = mesh
	add_child(shown, false, Node.INTERNAL_MODE_BACK)
