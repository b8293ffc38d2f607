@tool
@icon("res://scenes/world/icons/curtain.svg")
class_name Curtain
extends KitBlock
## A curtain in folds that hangs above its origin, the middle of its foot: a stage's legs, borders,
## what hides a wall.

## Width and height.
@export_custom(PROPERTY_HINT_NONE, "suffix:m") var size: Vector2 = Vector2(4.0, 4.0):
	set(p_value):
		size = p_value.clamp(Vector2(0.3, 0.2), Vector2(60.0, 30.0))
		queue_rebuild()
## Width of a fold.
@export_range(0.1, 2.0, 0.05, "suffix:m") var fold: float = 0.4:
	set(p_value):
		fold = clampf(p_value, 0.1, 2.0)
		queue_rebuild()
## How far folds stand out.
@export_range(0.0, 0.5, 0.01, "suffix:m") var depth: float = 0.09:
	set(p_value):
		depth = clampf(p_value, 0.0, 0.5)
		queue_rebuild()
## What it is made of.
@export var surface: SurfaceLayers.Layer = SurfaceLayers.Layer.BURLAP:
	set(p_value):
		surface = p_value
		queue_rebuild()
## Its colour.
@export var tint: SurfaceTints.Tint = SurfaceTints.Tint.BLACK:
	set(p_value):
		tint = p_value
		queue_rebuild()
## Whether it stops people and things; else they go through.
@export var is_solid: bool = true:
	set(p_value):
		is_solid = p_value
		queue_rebuild()


static func kit_entry() -> KitEntry:
	var entry: KitEntry = KitEntry.of_block(Curtain, 100, {"size": PropertyRule.vector2(0.2, 60.0)})
	entry.offered("Curtain", "cloth drape wing")
	return entry


func contact_key() -> StringName:
	return SurfaceLayers.key_of(surface)


func build(p_mesh: BlockMesh, _p_part: StringName) -> void:
	Drapery.new(size, fold, depth).build(p_mesh, surface, tint)
	if is_solid:
		var half: float = maxf(depth, 0.03)
		p_mesh.solid(Vector3(-size.x / 2.0, 0.0, -half), Vector3(size.x / 2.0, size.y, half))
