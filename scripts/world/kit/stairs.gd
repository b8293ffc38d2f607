@tool
@icon("res://scenes/world/icons/stairs.svg")
class_name Stairs
extends KitBlock
## A flight of stairs that rises along -Z from its origin, with a landing at the top.

## Number of steps.
@export_range(1, 64) var steps: int = 8:
	set(value):
		steps = maxi(value, 1)
		rebuild()
## Height of a step.
@export_range(0.05, 0.5, 0.005, "suffix:m") var rise: float = 0.17:
	set(value):
		rise = maxf(value, 0.01)
		rebuild()
## Depth of a step.
@export_range(0.1, 1.0, 0.005, "suffix:m") var going: float = 0.29:
	set(value):
		going = maxf(value, 0.05)
		rebuild()
## Width of the flight.
@export_range(0.5, 10.0, 0.05, "suffix:m") var width: float = 2.0:
	set(value):
		width = maxf(value, 0.1)
		rebuild()
## Depth of the landing behind the last step; 0 for none.
@export_range(0.0, 10.0, 0.05, "suffix:m") var landing: float = 1.5:
	set(value):
		landing = maxf(value, 0.0)
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
## A material of its own instead; such stairs are drawn by themselves and get no baked light.
@export var material: Material:
	set(value):
		material = value
		rebuild()


static func kit_entry() -> KitEntry:
	var entry: KitEntry = KitEntry.of_block(
		Stairs, 500, {"material": PropertyRule.resource(KitClass.MATERIALS)}
	)
	entry.offered("Stairs", "steps")
	return entry


func contact_key() -> StringName:
	return SurfaceLayers.key_of(surface)


func build(p_mesh: BlockMesh, _p_part: StringName) -> void:
	for box: AABB in _boxes():
		p_mesh.box(box.position, box.end, surface, tint, 0, true)


func is_merged() -> bool:
	return material == null


func rebuild() -> void:
	super()
	if material == null or not is_inside_tree():
		return
	for box: AABB in _boxes():
		var shown: MeshInstance3D = Block.make_plain_box(box.size, material)
		shown.position = box.get_center()
		add_child(shown, false, Node.INTERNAL_MODE_BACK)


func _get_configuration_warnings() -> PackedStringArray:
	var warnings: PackedStringArray = super()
	if 2.0 * rise + going < 0.55 or 2.0 * rise + going > 0.75:
		var text: String = "People walk steps with 2 x rise + going of 0.6 to 0.65 m; here it is %.2f m."
		warnings.append(text % (2.0 * rise + going))
	return warnings


func _boxes() -> Array[AABB]:
	var boxes: Array[AABB] = []
	for step: int in steps:
		var depth: float = going + (landing if step == steps - 1 else 0.0)
		var size: Vector3 = Vector3(width, rise * (step + 1), depth)
		boxes.append(AABB(Vector3(-width / 2.0, 0.0, -going * step - depth), size))
	return boxes
