@tool
@icon("res://scenes/world/icons/ladder.svg")
class_name Ladder
extends KitBlock
## A fixed ladder of steel along a wall: it stands on its origin, its open side looks to +Z.
##
## Who walks without a suit climbs it. A wearer only bumps into it, with no rungs to stand on: what
## everybody shall get onto needs stairs or a ramp too.

const _RUNG_M: float = 0.28
const _HALF: float = 0.23

## Height of what it leads to; its rails reach higher.
@export_range(1.0, 30.0, 0.1, "suffix:m") var height: float = 3.0:
	set(p_value):
		height = clampf(p_value, 1.0, 30.0)
		queue_rebuild()
## Whether hoops around it keep people from falling backwards, from 2.3 m on.
@export var has_hoops: bool = false:
	set(p_value):
		has_hoops = p_value
		queue_rebuild()
## Its colour.
@export var tint: SurfaceTints.Tint = SurfaceTints.Tint.YELLOW:
	set(p_value):
		tint = p_value
		queue_rebuild()


static func kit_entry() -> KitEntry:
	var entry: KitEntry = KitEntry.of_block(Ladder, 200)
	entry.offered("Ladder", "rungs")
	return entry


func contact_key() -> StringName:
	return &"metal"


func build(p_mesh: BlockMesh, _p_part: StringName) -> void:
	var paint: int = Steelwork.PAINT
	var top: float = height + 1.0
	for x: float in [-_HALF, _HALF]:
		var foot: Vector3 = Vector3(x, 0.0, 0.0)
		var size: Vector2 = Vector2(0.03, 0.06)
		Steelwork.beam(p_mesh, foot, foot + Vector3.UP * top, size, paint, tint)
	for rung: int in int(height / _RUNG_M):
		var y: float = _RUNG_M * (rung + 1)
		p_mesh.rod(Vector3(-_HALF, y, 0.0), Vector3(_HALF, y, 0.0), 0.015, 0.015, paint, tint, 6)
	p_mesh.solid(Vector3(-_HALF - 0.02, 0.0, -0.03), Vector3(_HALF + 0.02, height, 0.03))
	if has_hoops:
		var y: float = 2.3
		while y < top:
			_add_hoop(p_mesh, y)
			y += 0.8
		for part: int in 5:
			var at: Vector3 = _hoop_point(lerpf(0.0, PI, (part + 0.5) / 5.0))
			var from: Vector3 = at + Vector3.UP * 2.3
			Steelwork.beam(p_mesh, from, at + Vector3.UP * top, Vector2(0.03, 0.01), paint, tint)


func _add_hoop(p_mesh: BlockMesh, p_y: float) -> void:
	const PARTS: int = 8
	for part: int in PARTS:
		var from: Vector3 = _hoop_point(PI * part / PARTS) + Vector3.UP * p_y
		var to: Vector3 = _hoop_point(PI * (part + 1) / PARTS) + Vector3.UP * p_y
		Steelwork.beam(p_mesh, from, to, Vector2(0.05, 0.012), Steelwork.PAINT, tint)


func _hoop_point(p_angle: float) -> Vector3:
	return Vector3(cos(p_angle) * 0.36, 0.0, sin(p_angle) * 0.62)
