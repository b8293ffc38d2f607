@tool
@icon("res://scenes/world/icons/wall.svg")
class_name Wall
extends KitBlock
## A wall with openings. It goes from its origin to +X and looks to +Z.

const _CAP_M: float = 0.08
const _PIECE_M: float = 0.55

## Length, height and thickness.
@export_custom(PROPERTY_HINT_NONE, "suffix:m") var size: Vector3 = Vector3(4.0, 2.4, 0.3):
	set(p_value):
		size = p_value.clamp(Vector3(0.2, 0.2, 0.05), Vector3(100.0, 20.0, 4.0))
		rebuild()
## Openings: x, y, width and height from the lower left corner, m. One that begins at y = 0 is a
## doorway.
@export var openings: Array[Rect2] = []:
	set(p_value):
		openings = p_value
		rebuild()
## What it is made of.
@export var surface: SurfaceLayers.Layer = SurfaceLayers.Layer.PLASTER:
	set(p_value):
		surface = p_value
		rebuild()
## Its colour.
@export var tint: SurfaceTints.Tint = SurfaceTints.Tint.CREAM:
	set(p_value):
		tint = p_value
		rebuild()
## How broken its top is.
@export_range(0.0, 1.0, 0.05) var ruin: float = 0.0:
	set(p_value):
		ruin = clampf(p_value, 0.0, 1.0)
		rebuild()
## Whether stones cap it.
@export var cap: bool = true:
	set(p_value):
		cap = p_value
		rebuild()
## How much sand has been blown against it, 0 to 1.
@export_range(0.0, 1.0, 0.05) var sand: float = 1.0:
	set(p_value):
		sand = clampf(p_value, 0.0, 1.0)
		rebuild()


static func kit_entry() -> KitEntry:
	var door: Array[Rect2] = [Rect2(1.5, 0.0, 1.0, 2.1)]
	var window: Array[Rect2] = [Rect2(1.4, 0.9, 1.2, 1.2)]
	var entry: KitEntry = KitEntry.of_block(
		Wall, 3000, {"size": PropertyRule.vector3(0.05, 100.0), "openings": PropertyRule.openings()}
	)
	entry.offered("Wall", "fence")
	entry.offered("Wall with door", "opening", {&"openings": door})
	entry.offered("Wall with window", "opening", {&"openings": window})
	entry.offered("Low wall", "cover", {&"size": Vector3(3, 1.1, 0.4)})
	return entry


func _get_configuration_warnings() -> PackedStringArray:
	var warnings: PackedStringArray = super()
	for opening: Rect2 in openings:
		if not Rect2(Vector2.ZERO, Vector2(size.x, size.y)).encloses(opening):
			warnings.append(
				"An opening reaches beyond the wall: make it smaller, or the wall larger."
			)
		elif opening.position.y < 0.05 and (opening.size.x < 0.9 or opening.size.y < 2.0):
			warnings.append("People do not fit through a doorway of less than 0.9 x 2 m.")
	return warnings


func contact_key() -> StringName:
	return SurfaceLayers.key_of(surface)


func build(p_mesh: BlockMesh, _p_part: StringName) -> void:
	p_mesh.set_dust(sand, p_mesh.get_place().origin.y)
	if ruin > 0.0:
		_build_ruin(p_mesh)
		return
	var holes: PackedVector4Array = []
	var back: PackedVector4Array = []
	for opening: Rect2 in openings:
		var at: Vector2 = opening.position
		holes.append(Vector4(at.x, at.y, opening.size.x, opening.size.y))
		back.append(Vector4(size.x - opening.end.x, at.y, opening.size.x, opening.size.y))
		_add_reveal(p_mesh, opening)
	var extent: Vector2 = Vector2(size.x, size.y)
	var deep: Vector2 = Vector2(size.z, size.y)
	var far: Vector3 = Vector3(size.x, 0.0, -size.z)
	p_mesh.face(Vector3.ZERO, Vector3.RIGHT, Vector3.UP, extent, surface, tint, holes)
	p_mesh.face(far, Vector3.LEFT, Vector3.UP, extent, surface, tint, back)
	p_mesh.face(Vector3(size.x, 0.0, 0.0), Vector3.FORWARD, Vector3.UP, deep, surface, tint)
	p_mesh.face(Vector3(0.0, 0.0, -size.z), Vector3.BACK, Vector3.UP, deep, surface, tint)
	_add_top(p_mesh)
	for solid: AABB in _solids():
		p_mesh.solid(solid.position, solid.end)


func _add_top(p_mesh: BlockMesh) -> void:
	if cap:
		p_mesh.box(
			Vector3(-0.04, size.y, -size.z - 0.05),
			Vector3(size.x + 0.04, size.y + _CAP_M, 0.05),
			SurfaceLayers.Layer.CONCRETE,
			SurfaceTints.Tint.TRIM_PALE
		)
		return
	var corner: Vector3 = Vector3(0.0, size.y, 0.0)
	var extent: Vector2 = Vector2(size.x, size.z)
	p_mesh.face(corner, Vector3.RIGHT, Vector3.FORWARD, extent, surface, tint)


func _add_reveal(p_mesh: BlockMesh, p_opening: Rect2) -> void:
	var left: Vector3 = Vector3(p_opening.position.x, p_opening.position.y, 0.0)
	var right: Vector3 = left + Vector3(p_opening.size.x, 0.0, -size.z)
	var side: Vector2 = Vector2(size.z, p_opening.size.y)
	var across: Vector2 = Vector2(p_opening.size.x, size.z)
	var top: Vector3 = right + Vector3(0.0, p_opening.size.y, size.z)
	p_mesh.face(left, Vector3.FORWARD, Vector3.UP, side, surface, tint)
	p_mesh.face(right, Vector3.BACK, Vector3.UP, side, surface, tint)
	p_mesh.face(top, Vector3.LEFT, Vector3.FORWARD, across, surface, tint)
	if p_opening.position.y > 0.01:
		var stone: int = SurfaceLayers.Layer.CONCRETE
		var trim: int = SurfaceTints.Tint.TRIM_PALE
		p_mesh.face(left, Vector3.RIGHT, Vector3.FORWARD, across, stone, trim)


## Columns between the openings, and what is over and under them.
func _solids() -> Array[AABB]:
	var sorted: Array[Rect2] = openings.duplicate()
	sorted.sort_custom(func(p_a: Rect2, p_b: Rect2) -> bool: return p_a.position.x < p_b.position.x)
	var rects: Array[Rect2] = []
	var x: float = 0.0
	for opening: Rect2 in sorted:
		var wide: float = opening.size.x
		rects.append(Rect2(x, 0.0, opening.position.x - x, size.y))
		rects.append(Rect2(opening.position.x, 0.0, wide, opening.position.y))
		rects.append(Rect2(opening.position.x, opening.end.y, wide, size.y - opening.end.y))
		x = opening.end.x
	rects.append(Rect2(x, 0.0, size.x - x, size.y))
	var boxes: Array[AABB] = []
	for rect: Rect2 in rects:
		if rect.size.x > 0.01 and rect.size.y > 0.01:
			var corner: Vector3 = Vector3(rect.position.x, rect.position.y, -size.z)
			boxes.append(AABB(corner, Vector3(rect.size.x, rect.size.y, size.z)))
	return boxes


## Pieces of different height.
func _build_ruin(p_mesh: BlockMesh) -> void:
	var dice: RandomNumberGenerator = RandomNumberGenerator.new()
	dice.seed = seed_of_place()
	var count: int = maxi(1, roundi(size.x / _PIECE_M))
	var high: float = size.y
	for piece: int in count:
		var change: float = dice.randf_range(-1.0, 0.85) * ruin * size.y * 0.4
		high = clampf(high + change, size.y * 0.18, size.y)
		var x: float = size.x * piece / count
		var end: Vector3 = Vector3(x + size.x / count, high, 0.0)
		var hidden: int = BlockMesh.FACE_BOTTOM
		p_mesh.box(Vector3(x, 0.0, -size.z), end, surface, tint, hidden, true)
