@tool
@icon("res://scenes/world/icons/steel_hall.svg")
class_name SteelHall
extends KitBlock
## The shell of an industrial hall: a floor of concrete slabs, walls of corrugated sheet on a base
## of concrete, steel frames with trusses, and a gable roof whose ridge runs along X.
##
## Its origin is the middle of the floor's upper side. An opening at least 2.5 m wide that begins at
## the floor becomes a gate, a narrower one a door, and one higher up a window.

const _SLAB_M: float = 5.0
const _FLOOR_M: float = 0.25

## Length along X, height of the eaves, depth along Z, all inside.
@export_custom(PROPERTY_HINT_NONE, "suffix:m") var size: Vector3 = Vector3(20.0, 5.0, 12.0):
	set(p_value):
		size = p_value.clamp(Vector3(4.0, 2.5, 4.0), Vector3(200.0, 30.0, 100.0))
		queue_rebuild()
## How much higher the ridge is than the eaves.
@export_range(0.3, 10.0, 0.1, "suffix:m") var rise: float = 2.0:
	set(p_value):
		rise = clampf(p_value, 0.3, 10.0)
		queue_rebuild()
## Number of fields between steel frames.
@export_range(1, 40) var bays: int = 4:
	set(p_value):
		bays = clampi(p_value, 1, 40)
		queue_rebuild()
## Whether every second field of the roof lets light in.
@export var has_skylights: bool = true:
	set(p_value):
		has_skylights = p_value
		queue_rebuild()
## Height of the concrete below the sheet.
@export_range(0.0, 3.0, 0.05, "suffix:m") var base: float = 1.0:
	set(p_value):
		base = clampf(p_value, 0.0, 3.0)
		queue_rebuild()
@export_group("Openings")
## In the wall towards +Z: x, y, width and height from its lower left corner as seen from outside,
## m.
@export var south: Array[Rect2] = []:
	set(p_value):
		south = p_value
		queue_rebuild()
## In the wall towards -Z.
@export var north: Array[Rect2] = []:
	set(p_value):
		north = p_value
		queue_rebuild()
## In the wall towards +X.
@export var east: Array[Rect2] = []:
	set(p_value):
		east = p_value
		queue_rebuild()
## In the wall towards -X.
@export var west: Array[Rect2] = []:
	set(p_value):
		west = p_value
		queue_rebuild()
@export_group("Colours")
## The sheet outside.
@export var outside: SurfaceTints.Tint = SurfaceTints.Tint.BLUE:
	set(p_value):
		outside = p_value
		queue_rebuild()
## The sheet inside.
@export var inside: SurfaceTints.Tint = SurfaceTints.Tint.WHITE:
	set(p_value):
		inside = p_value
		queue_rebuild()
## Frames, trusses and gates.
@export var steel: SurfaceTints.Tint = SurfaceTints.Tint.NAVY:
	set(p_value):
		steel = p_value
		queue_rebuild()


static func kit_entry() -> KitEntry:
	var entry: KitEntry = KitEntry.of_block(
		SteelHall,
		20,
		{
			"size": PropertyRule.vector3(2.5, 200.0),
			"south": PropertyRule.openings(),
			"north": PropertyRule.openings(),
			"east": PropertyRule.openings(),
			"west": PropertyRule.openings()
		}
	)
	entry.offered("Steel hall", "building hangar")
	return entry


func _get_configuration_warnings() -> PackedStringArray:
	var warnings: PackedStringArray = super()
	for wall: HallWall in _walls():
		for opening: Rect2 in wall.openings:
			if not Rect2(Vector2.ZERO, wall.size).encloses(opening):
				warnings.append("An opening reaches beyond its wall: make it smaller or move it.")
			elif opening.position.y < 0.05 and (opening.size.x < 0.9 or opening.size.y < 2.0):
				warnings.append("People do not fit through a door of less than 0.9 x 2 m.")
	if size.x / bays > 10.0:
		warnings.append("Frames stand more than 10 m apart: choose more bays.")
	return warnings


func stands_alone() -> bool:
	return true


func contact_key() -> StringName:
	return &"concrete"


func build(p_mesh: BlockMesh, _p_part: StringName) -> void:
	_add_floor(p_mesh)
	var place: Transform3D = p_mesh.get_place()
	var walls: Array[HallWall] = _walls()
	var thick: float = HallWall.THICK
	for side: int in walls.size():
		var turn: Basis = Basis(Vector3.UP, PI / 2.0 * side)
		var deep: float = (size.z if side % 2 == 0 else size.x) / 2.0 + thick
		var corner: Vector3 = turn * Vector3(-walls[side].size.x / 2.0, 0.0, deep)
		p_mesh.set_place(place * Transform3D(turn, corner))
		walls[side].build(p_mesh)
	p_mesh.set_place(place)
	var roof: HallRoof = HallRoof.new()
	roof.size = size + Vector3(2.0, 0.0, 2.0) * thick
	roof.rise = rise
	roof.bays = bays
	roof.has_skylights = has_skylights
	roof.outside = outside
	roof.inside = inside
	roof.steel = steel
	roof.free_south = _doors_along_x(south, 1.0)
	roof.free_north = _doors_along_x(north, -1.0)
	roof.build(p_mesh)


## Doors and gates of a long wall, from and to along X, m.
func _doors_along_x(p_openings: Array[Rect2], p_way: float) -> PackedVector2Array:
	var found: PackedVector2Array = []
	for opening: Rect2 in p_openings:
		if opening.position.y < 0.05:
			var from: float = (opening.position.x - size.x / 2.0 - HallWall.THICK) * p_way
			var to: float = (opening.end.x - size.x / 2.0 - HallWall.THICK) * p_way
			found.append(Vector2(minf(from, to), maxf(from, to)))
	return found


## South, east, north, west: each a quarter turn further.
func _walls() -> Array[HallWall]:
	var walls: Array[HallWall] = []
	var all: Array[Array] = [south, east, north, west]
	for side: int in all.size():
		var wall: HallWall = HallWall.new()
		var length: float = size.x if side % 2 == 0 else size.z
		wall.size = Vector2(length + 2.0 * HallWall.THICK, size.y)
		wall.base = base
		wall.openings.assign(all[side])
		wall.outside = outside
		wall.inside = inside
		wall.frame = steel
		walls.append(wall)
	return walls


## Slabs with joints between them, each with another part of the picture.
func _add_floor(p_mesh: BlockMesh) -> void:
	const JOINT: float = 0.012
	var half: Vector2 = Vector2(size.x, size.z) / 2.0 + Vector2.ONE * HallWall.THICK
	p_mesh.solid(Vector3(-half.x, -_FLOOR_M, -half.y), Vector3(half.x, 0.0, half.y))
	var counts: Vector2i = Vector2i((half * 2.0 / _SLAB_M).round().max(Vector2.ONE))
	var slab: Vector2 = half * 2.0 / Vector2(counts)
	for number: int in counts.x * counts.y:
		var at: Vector2 = Vector2(number % counts.x, number / counts.x)
		var corner: Vector2 = at * slab - half
		p_mesh.set_uv_shift(Vector2(fmod(at.x * 0.37 + at.y * 0.61, 1.0), fmod(at.y * 0.29, 1.0)))
		p_mesh.face(
			Vector3(corner.x + JOINT, 0.0, corner.y + slab.y - JOINT),
			Vector3.RIGHT,
			Vector3.FORWARD,
			slab - Vector2.ONE * 2.0 * JOINT,
			SurfaceLayers.Layer.CONCRETE,
			SurfaceTints.Tint.PLAIN
		)
	p_mesh.set_uv_shift(Vector2.ZERO)
	p_mesh.set_finest(5.0)
	p_mesh.face(
		Vector3(-half.x, -0.01, half.y),
		Vector3.RIGHT,
		Vector3.FORWARD,
		half * 2.0,
		SurfaceLayers.Layer.CONCRETE,
		SurfaceTints.Tint.TRIM_BROWN
	)
	p_mesh.set_finest(1.25)
