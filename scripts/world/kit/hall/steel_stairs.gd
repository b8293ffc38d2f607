@tool
@icon("res://scenes/world/icons/stairs.svg")
class_name SteelStairs
extends KitBlock
## A flight of stairs of tread plate between two stringers, with railings. It rises along -Z from
## its origin; its last tread is level with what it leads to.

## Number of steps.
@export_range(1, 64) var steps: int = 12:
	set(p_value):
		steps = clampi(p_value, 1, 64)
		queue_rebuild()
## Height of a step.
@export_range(0.1, 0.25, 0.001, "suffix:m") var rise: float = 0.17:
	set(p_value):
		rise = clampf(p_value, 0.1, 0.25)
		queue_rebuild()
## Depth of a step.
@export_range(0.2, 0.5, 0.005, "suffix:m") var going: float = 0.28:
	set(p_value):
		going = clampf(p_value, 0.2, 0.5)
		queue_rebuild()
## Width of the flight.
@export_range(0.6, 5.0, 0.05, "suffix:m") var width: float = 1.2:
	set(p_value):
		width = clampf(p_value, 0.6, 5.0)
		queue_rebuild()
## Height of its railings; 0 for none.
@export_range(0.0, 1.5, 0.05, "suffix:m") var railing: float = 1.0:
	set(p_value):
		railing = clampf(p_value, 0.0, 1.5)
		queue_rebuild()
## Stringers.
@export var tint: SurfaceTints.Tint = SurfaceTints.Tint.NAVY:
	set(p_value):
		tint = p_value
		queue_rebuild()
## Railings.
@export var rails: SurfaceTints.Tint = SurfaceTints.Tint.YELLOW:
	set(p_value):
		rails = p_value
		queue_rebuild()


static func kit_entry() -> KitEntry:
	var entry: KitEntry = KitEntry.of_block(SteelStairs, 200)
	entry.offered("Steel stairs", "steps")
	return entry


func _get_configuration_warnings() -> PackedStringArray:
	var warnings: PackedStringArray = super()
	if 2.0 * rise + going < 0.55 or 2.0 * rise + going > 0.75:
		var text: String = "People walk steps with 2 x rise + going of 0.6 to 0.65 m; here it is %.2f m."
		warnings.append(text % (2.0 * rise + going))
	return warnings


func contact_key() -> StringName:
	return &"metal"


func build(p_mesh: BlockMesh, _p_part: StringName) -> void:
	var half: float = width / 2.0
	var top: Vector3 = Vector3(0.0, rise * steps, -going * steps)
	for step: int in steps:
		var y: float = rise * (step + 1)
		var z: float = -going * step
		p_mesh.box(
			Vector3(-half, y - 0.04, z - going - 0.02),
			Vector3(half, y, z),
			SurfaceLayers.Layer.STEEL,
			SurfaceTints.Tint.PLAIN
		)
		# A thin tread would let a foot in below the next one.
		p_mesh.solid(Vector3(-half, y - rise * 1.2, z - going), Vector3(half, y, z))
	for side: float in [-half - 0.02, half + 0.02]:
		var from: Vector3 = Vector3(side, rise * 0.35, 0.0)
		var to: Vector3 = Vector3(side, top.y - rise * 0.65, top.z)
		Steelwork.beam(p_mesh, from, to, Vector2(0.04, 0.26), Steelwork.PAINT, tint)
		if railing > 0.0:
			var up: Vector3 = Vector3(side, 0.0, 0.0)
			var low: Vector3 = up + Vector3.UP * rise
			Steelwork.railing(p_mesh, low, up + top, railing, rails)
