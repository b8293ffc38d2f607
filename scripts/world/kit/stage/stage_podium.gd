@tool
@icon("res://scenes/world/icons/stage_podium.svg")
class_name StagePodium
extends KitBlock
## A stage's floor of dark panels around the middle of its foot, with a rim of metal and cloth in
## folds down to the ground.

const _RIM_M: float = 0.12
const _PANEL_M: Vector2 = Vector2(2.0, 1.0)
const _JOINT_M: float = 0.006

## Width, height and depth.
@export_custom(PROPERTY_HINT_NONE, "suffix:m") var size: Vector3 = Vector3(8.0, 1.0, 6.0):
	set(p_value):
		size = p_value.clamp(Vector3(1.0, 0.2, 1.0), Vector3(60.0, 4.0, 60.0))
		queue_rebuild()
## Colour of its panels.
@export var tint: SurfaceTints.Tint = SurfaceTints.Tint.IRON:
	set(p_value):
		tint = p_value
		queue_rebuild()
## Colour of the cloth around it.
@export var skirt: SurfaceTints.Tint = SurfaceTints.Tint.BLACK:
	set(p_value):
		skirt = p_value
		queue_rebuild()


static func kit_entry() -> KitEntry:
	var entry: KitEntry = KitEntry.of_block(
		StagePodium, 20, {"size": PropertyRule.vector3(0.2, 60.0)}
	)
	entry.offered("Stage", "podium platform")
	return entry


func stands_alone() -> bool:
	return true


func contact_key() -> StringName:
	return &"wood"


func build(p_mesh: BlockMesh, _p_part: StringName) -> void:
	var half: Vector3 = Vector3(size.x / 2.0, 0.0, size.z / 2.0)
	p_mesh.solid(-half, half + Vector3.UP * size.y)
	# Light falls on it in spots: finer than elsewhere.
	p_mesh.set_finest(0.8)
	_add_boards(p_mesh, half)
	p_mesh.set_finest(1.25)
	var place: Transform3D = p_mesh.get_place()
	for side: int in 4:
		var turn: Basis = Basis(Vector3.UP, PI / 2.0 * side)
		var wide: float = size.x if side % 2 == 0 else size.z
		var deep: float = half.z if side % 2 == 0 else half.x
		p_mesh.set_place(place * Transform3D(turn, turn * Vector3(0.0, 0.0, deep)))
		p_mesh.box(
			Vector3(-wide / 2.0, size.y - _RIM_M, -0.02),
			Vector3(wide / 2.0, size.y + 0.003, 0.025),
			Steelwork.PAINT,
			SurfaceTints.Tint.IRON
		)
		p_mesh.set_place(place * Transform3D(turn, turn * Vector3(0.0, 0.0, deep - 0.06)))
		var cloth: Drapery = Drapery.new(Vector2(wide - 0.1, size.y - 0.02), 0.3, 0.04)
		cloth.build(p_mesh, SurfaceLayers.Layer.BURLAP, skirt)
	p_mesh.set_place(place)


## Panels with joints between them, over black.
func _add_boards(p_mesh: BlockMesh, p_half: Vector3) -> void:
	var counts: Vector2i = Vector2i((Vector2(size.x, size.z) / _PANEL_M).round().max(Vector2.ONE))
	var panel: Vector2 = Vector2(size.x, size.z) / Vector2(counts)
	for number: int in counts.x * counts.y:
		var at: Vector2 = Vector2(number % counts.x, number / counts.x) * panel
		p_mesh.set_uv_shift(Vector2(fmod(number * 0.37, 1.0), fmod(number * 0.61, 1.0)))
		p_mesh.face(
			Vector3(at.x - p_half.x + _JOINT_M, size.y, p_half.z - at.y - _JOINT_M),
			Vector3.RIGHT,
			Vector3.FORWARD,
			panel - Vector2.ONE * 2.0 * _JOINT_M,
			Steelwork.PAINT,
			tint
		)
	p_mesh.set_uv_shift(Vector2.ZERO)
	p_mesh.set_finest(4.0)
	p_mesh.face(
		Vector3(-p_half.x, size.y - 0.006, p_half.z),
		Vector3.RIGHT,
		Vector3.FORWARD,
		Vector2(size.x, size.z),
		Steelwork.PAINT,
		SurfaceTints.Tint.BLACK
	)
