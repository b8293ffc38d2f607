@tool
@icon("res://scenes/world/icons/gallery.svg")
class_name Gallery
extends KitBlock
## A platform of tread plate on posts with railings. It goes from its origin, the corner on the
## floor below its left front edge, to +X and -Z; gaps in its railings let people on.

const _DECK_M: float = 0.06
const _BAY_M: float = 4.0

## Length, height of the deck, depth.
@export_custom(PROPERTY_HINT_NONE, "suffix:m") var size: Vector3 = Vector3(8.0, 3.0, 2.0):
	set(p_value):
		size = p_value.clamp(Vector3(1.0, 0.5, 0.8), Vector3(100.0, 20.0, 20.0))
		queue_rebuild()
## Height of its railings.
@export_range(0.5, 1.5, 0.05, "suffix:m") var railing: float = 1.1:
	set(p_value):
		railing = clampf(p_value, 0.5, 1.5)
		queue_rebuild()
@export_group("Gaps")
## Gaps in the front railing: from and to along X, m.
@export var front: PackedVector2Array = []:
	set(p_value):
		front = p_value
		queue_rebuild()
## Whether the left end is open.
@export var is_open_left: bool = false:
	set(p_value):
		is_open_left = p_value
		queue_rebuild()
## Whether the right end is open.
@export var is_open_right: bool = false:
	set(p_value):
		is_open_right = p_value
		queue_rebuild()
## Whether there is no railing at the back, as along a wall.
@export var is_open_back: bool = true:
	set(p_value):
		is_open_back = p_value
		queue_rebuild()
@export_group("Colours")
## Posts and beams.
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
	var entry: KitEntry = KitEntry.of_block(
		Gallery, 200, {"size": PropertyRule.vector3(0.5, 100.0), "front": PropertyRule.gaps()}
	)
	entry.offered("Gallery", "platform railing")
	return entry


func _get_configuration_warnings() -> PackedStringArray:
	var warnings: PackedStringArray = super()
	for gap: Vector2 in front:
		if gap.x < 0.0 or gap.y > size.x or gap.y - gap.x < 0.6:
			warnings.append("A gap must lie within the length and be 0.6 m wide for people.")
	if size.y < 2.3 and size.z > 1.0:
		warnings.append("People do not stand upright below a deck of less than 2.3 m.")
	return warnings


func contact_key() -> StringName:
	return &"metal"


func build(p_mesh: BlockMesh, _p_part: StringName) -> void:
	var deck: Vector3 = Vector3(size.x, size.y, 0.0)
	p_mesh.box(
		Vector3(0.0, size.y - _DECK_M, -size.z),
		deck,
		SurfaceLayers.Layer.STEEL,
		SurfaceTints.Tint.PLAIN,
		0,
		true
	)
	_add_beams(p_mesh)
	var y: Vector3 = Vector3.UP * size.y
	for piece: Vector2 in _pieces():
		_rail(p_mesh, Vector3(piece.x, size.y, -0.04), Vector3(piece.y, size.y, -0.04))
	if not is_open_left:
		_rail(p_mesh, y + Vector3(0.04, 0.0, 0.0), y + Vector3(0.04, 0.0, -size.z))
	if not is_open_right:
		_rail(p_mesh, y + Vector3(size.x - 0.04, 0, 0), y + Vector3(size.x - 0.04, 0, -size.z))
	if not is_open_back:
		_rail(p_mesh, y + Vector3(0, 0, 0.04 - size.z), y + Vector3(size.x, 0, 0.04 - size.z))


func _rail(p_mesh: BlockMesh, p_from: Vector3, p_to: Vector3) -> void:
	Steelwork.railing(p_mesh, p_from, p_to, railing, rails)


## The front railing without its gaps.
func _pieces() -> PackedVector2Array:
	var gaps: PackedVector2Array = front.duplicate()
	gaps.sort()
	var pieces: PackedVector2Array = []
	var x: float = 0.0
	for gap: Vector2 in gaps:
		if gap.x - x > 0.05:
			pieces.append(Vector2(x, gap.x))
		x = maxf(x, gap.y)
	if size.x - x > 0.05:
		pieces.append(Vector2(x, size.x))
	return pieces


func _add_beams(p_mesh: BlockMesh) -> void:
	var under: float = size.y - _DECK_M - 0.1
	for z: float in [-0.1, 0.1 - size.z]:
		var from: Vector3 = Vector3(0.0, under, z)
		Steelwork.profile(p_mesh, from, Vector3(size.x, under, z), Vector2(0.12, 0.2), tint)
	var joists: int = maxi(1, roundi(size.x / 1.25))
	for joist: int in joists + 1:
		var x: float = lerpf(0.06, size.x - 0.06, float(joist) / joists)
		var from: Vector3 = Vector3(x, under + 0.04, -0.1)
		var to: Vector3 = Vector3(x, under + 0.04, 0.1 - size.z)
		Steelwork.beam(p_mesh, from, to, Vector2(0.06, 0.12), Steelwork.PAINT, tint)
	var posts: int = maxi(1, roundi(size.x / _BAY_M))
	for post: int in posts + 1:
		var x: float = lerpf(0.1, size.x - 0.1, float(post) / posts)
		for z: float in [-0.12, 0.12 - size.z]:
			var foot: Vector3 = Vector3(x, 0.0, z)
			var top: Vector3 = Vector3(x, under - 0.1, z)
			Steelwork.profile(p_mesh, foot, top, Vector2(0.14, 0.14), tint, true)
			var plate: Vector3 = Vector3(0.14, 0.0, 0.14)
			var iron: int = SurfaceTints.Tint.IRON
			p_mesh.box(foot - plate, foot + plate + Vector3.UP * 0.015, Steelwork.PAINT, iron)
