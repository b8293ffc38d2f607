class_name LevelBaker
extends RefCounted
## Works out a [LevelBake] of a level: seconds of work, in a thread where there is a window to keep
## alive.

## Rays from each point, and number of bounces.
const RAYS: int = 128
const BOUNCES: int = 3
## Distances of the points of the grid of light, m.
const GRID_M: Vector3 = Vector3(1.5, 1.5, 1.5)
## How much of its colour light loses when it is thrown back.
const GREY: float = 0.6
## Distance of the points of terrain that light is traced against, m, and the colour of its sand.
const GROUND_M: float = 4.0
const GROUND_COLOUR: Color = Color(0.42, 0.30, 0.18)
## Edge of the cells of visibility, m.
const CELL_M: float = 4.0
## Greatest height of eyes above the lowest floor, m, for which visibility is computed: from higher
## up everything is visible.
const EYES_M: float = 12.0
## How far below the lowest spawn point floors are, m.
const SUNK_M: float = 0.05
## How far the grid of light reaches above and beside the blocks, m.
const AIR_M: Vector3 = Vector3(3.0, 3.0, 3.0)

## Directions towards the suns: morning (east, 15 degrees high), noon (south, 65 degrees) and
## evening (west, 15 degrees).
const SUNS: Array[Vector3] = [
	Vector3(0.9659, 0.2588, 0.0), Vector3(0.0, 0.9063, 0.4226), Vector3(-0.9659, 0.2588, 0.0)
]

## What was worked out.
var bake: LevelBake = LevelBake.new()
## Whether to compute what can be seen from where, which takes longest.
var has_visibility: bool = true

var _tracer: LevelTracer = LevelTracer.new()
var _bounds: AABB = AABB()
# Height of the lowest floor that people stand on, m.
var _floor: float = 0.0


## Takes a level's parts and lamps. The level must be in the tree.
func prepare(p_level: Node3D) -> void:
	_tracer.set_palette(_greyer(SurfaceLayers.AVERAGE), _greyer(SurfaceTints.linear()))
	_tracer.set_suns(SUNS[0], SUNS[1], SUNS[2])
	_tracer.set_effort(RAYS, BOUNCES, OS.get_processor_count())
	var parts: Array[SurfacePart] = SurfacePart.gather(p_level)
	for part: SurfacePart in parts:
		_tracer.add_part(part.mesh)
		bake.keys.append(part.key)
		bake.counts.append(part.mesh.get_vertex_count())
		for point: Vector3 in part.mesh.get_points():
			_bounds = AABB(point, Vector3.ZERO) if _bounds == AABB() else _bounds.expand(point)
	_add_ground(p_level)
	for lamp: LampLight in SurfacePart.gather_lamps(p_level):
		_tracer.add_lamp(lamp.position, lamp.colour, lamp.range_m, lamp.way, lamp.angle)
	_floor = _lowest_floor(p_level)
	bake.source_hash = LevelBake.hash_of(parts)


## Does the work; may run in a thread.
func run() -> void:
	_tracer.bake()
	for part: int in bake.keys.size():
		bake.light.append_array(_tracer.get_light(part))
	var air: AABB = _bounds.grow(0.0)
	air.position -= AIR_M
	air.size += 2.0 * AIR_M
	bake.grid_origin = air.position
	bake.grid_spacing = GRID_M
	bake.grid_counts = Vector3i((air.size / GRID_M).ceil()) + Vector3i.ONE
	bake.grid = _tracer.make_grid(bake.grid_origin, bake.grid_spacing, bake.grid_counts)
	if has_visibility:
		_survey()


## Share of the work that is done, 0 to 1.
func progress() -> float:
	return _tracer.get_progress()


## Terrain hides and throws back light, but has none of its own here.
func _add_ground(p_level: Node3D) -> void:
	for node: Node in p_level.find_children("*", "StaticBody3D", true, false):
		var terrain: Terrain = node as Terrain
		if terrain == null or terrain.field == null:
			continue
		var ground: Array = TerrainMesh.make_coarse(terrain.field, GROUND_M)
		var points: PackedVector3Array = ground[Mesh.ARRAY_VERTEX]
		# Below the floors that lie on it.
		var place: Vector3 = SurfacePart.place_of(terrain, p_level).origin + Vector3.DOWN * 0.1
		for index: int in points.size():
			points[index] += place
		_tracer.add_surface(
			points, ground[Mesh.ARRAY_NORMAL], ground[Mesh.ARRAY_INDEX], GROUND_COLOUR
		)


## Colours with less colour: what is thrown back often would else be as red as a lamp.
static func _greyer(p_colours: Array) -> PackedColorArray:
	var result: PackedColorArray = []
	for colour: Color in p_colours:
		var grey: float = colour.get_luminance()
		result.append(colour.lerp(Color(grey, grey, grey), GREY))
	return result


func _survey() -> void:
	var box: AABB = _bounds
	box.position.y = _floor
	box.size.y = minf(_bounds.end.y - _floor, EYES_M)
	bake.cell_size = CELL_M
	bake.cell_counts = Vector3i((box.size / CELL_M).ceil().max(Vector3.ONE))
	while bake.cell_counts.x * bake.cell_counts.y * bake.cell_counts.z > LevelBake.MAX_CELLS:
		bake.cell_size *= 1.25
		bake.cell_counts = Vector3i((box.size / bake.cell_size).ceil().max(Vector3.ONE))
	bake.cell_origin = box.get_center() - Vector3(bake.cell_counts) * bake.cell_size / 2.0
	bake.cell_origin.y = _floor
	if _tracer.survey(bake.cell_origin, bake.cell_size, bake.cell_counts):
		bake.seen_parts = _tracer.get_seen_parts()
		bake.divisions = _tracer.get_divisions()
		bake.seen_cells = _tracer.get_seen_cells()


## The height of the lowest spawn point, or of what lies lowest where there is none.
func _lowest_floor(p_level: Node3D) -> float:
	var lowest: float = INF
	for node: Node in p_level.find_children("*", "Marker3D", true, false):
		lowest = minf(lowest, SurfacePart.place_of(node as Node3D, p_level).origin.y)
	return lowest - SUNK_M if lowest < INF else _bounds.position.y
