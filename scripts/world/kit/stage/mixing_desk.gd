@tool
@icon("res://scenes/world/icons/mixing_desk.svg")
class_name MixingDesk
extends KitBlock
## A table with a desk for light or sound, around the middle of its foot; who works there stands at
## +Z and looks to -Z.

const _DEPTH_M: float = 0.8
const _HIGH_M: float = 0.76

## Width.
@export_range(0.8, 6.0, 0.1, "suffix:m") var width: float = 2.0:
	set(p_value):
		width = clampf(p_value, 0.8, 6.0)
		queue_rebuild()


static func kit_entry() -> KitEntry:
	var entry: KitEntry = KitEntry.of_block(MixingDesk, 50)
	entry.offered("Mixing desk", "table sound light")
	return entry


func contact_key() -> StringName:
	return &"metal"


func build(p_mesh: BlockMesh, _p_part: StringName) -> void:
	var half: float = width / 2.0
	var black: int = SurfaceTints.Tint.BLACK
	var paint: int = Steelwork.PAINT
	var deep: float = _DEPTH_M / 2.0
	p_mesh.box(
		Vector3(-half, _HIGH_M - 0.04, -deep),
		Vector3(half, _HIGH_M, deep),
		SurfaceLayers.Layer.WOOD,
		SurfaceTints.Tint.PLAIN
	)
	p_mesh.box(
		Vector3(-half, 0.05, -deep), Vector3(half, _HIGH_M - 0.04, 0.03 - deep), paint, black
	)
	for side: float in [-half, half - 0.04]:
		p_mesh.box(
			Vector3(side, 0.0, -deep), Vector3(side + 0.04, _HIGH_M - 0.04, deep), paint, black
		)
	p_mesh.solid(Vector3(-half, 0.0, -deep), Vector3(half, _HIGH_M + 0.12, deep))
	var place: Transform3D = p_mesh.get_place()
	var slant: Transform3D = Transform3D(Basis(Vector3.RIGHT, 0.22), Vector3(0, _HIGH_M, 0.3))
	p_mesh.set_place(place * slant)
	var wide: float = half - 0.25
	p_mesh.box(Vector3(-wide, 0.0, -0.55), Vector3(wide, 0.07, 0.0), paint, SurfaceTints.Tint.IRON)
	var strips: int = roundi(wide * 2.0 / 0.07)
	for strip: int in strips:
		var x: float = lerpf(0.05 - wide, wide - 0.05, float(strip) / maxi(1, strips - 1))
		p_mesh.box(Vector3(x - 0.006, 0.07, -0.22), Vector3(x + 0.006, 0.072, -0.04), paint, black)
		var pushed: float = -0.05 - 0.15 * absf(sin(strip * 2.4))
		_knob(p_mesh, Vector3(x, 0.07, pushed), SurfaceTints.Tint.WHITE)
		for row: int in 4:
			var colours: Array[int] = [
				SurfaceTints.Tint.RED,
				SurfaceTints.Tint.YELLOW,
				SurfaceTints.Tint.TURQUOISE,
				SurfaceTints.Tint.GREY_STONE,
			]
			_knob(p_mesh, Vector3(x, 0.07, -0.29 - 0.06 * row), colours[(row + strip / 8) % 4])
	p_mesh.set_place(place)


func _knob(p_mesh: BlockMesh, p_at: Vector3, p_tint: int) -> void:
	p_mesh.box(
		p_at - Vector3(0.011, 0.0, 0.014),
		p_at + Vector3(0.011, 0.018, 0.014),
		Steelwork.PAINT,
		p_tint
	)
