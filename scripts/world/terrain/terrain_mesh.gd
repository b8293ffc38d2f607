@tool
class_name TerrainMesh
extends RefCounted
## The meshes of a terrain: one flat grid with levels of detail that all pieces share, moved to its
## heights by the shader; and hills around it, so that nobody sees an edge.

## Cells along the edge of a piece.
const CELLS: int = 96
## Steps of the levels of detail, cells, and the error of each, m for each m of cell.
const STEPS: PackedInt32Array = [1, 2, 4, 8, 16]
const ERRORS: PackedFloat32Array = [0.0, 0.09, 0.26, 0.7, 1.7]
## How far the hills reach beyond the edge, m.
const HILLS_M: float = 1600.0
## Distance of points of the hills along the edge, m.
const HILLS_STEP_M: float = 12.5
## Rings of hills.
const RINGS: int = 14


## The grid of a piece: VERTEX.xz in cells, VERTEX.y 1 for points of the skirt that hides gaps
## between levels of detail.
static func make_piece(p_cell_m: float) -> ArrayMesh:
	var points: PackedVector3Array = []
	var side: int = CELLS + 1
	for row: int in side:
		for column: int in side:
			points.append(Vector3(column, 0.0, row))
	for row: int in side:
		for column: int in side:
			if row == 0 or column == 0 or row == CELLS or column == CELLS:
				points.append(Vector3(column, 1.0, row))
	var arrays: Array = []
	arrays.resize(Mesh.ARRAY_MAX)
	arrays[Mesh.ARRAY_VERTEX] = points
	arrays[Mesh.ARRAY_INDEX] = _indices(1)
	var lods: Dictionary = {}
	for level: int in range(1, STEPS.size()):
		lods[ERRORS[level] * p_cell_m] = _indices(STEPS[level])
	var mesh: ArrayMesh = ArrayMesh.new()
	mesh.add_surface_from_arrays(Mesh.PRIMITIVE_TRIANGLES, arrays, [], lods)
	return mesh


## Hills from the edge of a field outwards, in its frame.
static func make_hills(p_field: HeightField, p_seed: int) -> ArrayMesh:
	var noise: FastNoiseLite = FastNoiseLite.new()
	noise.seed = p_seed
	noise.frequency = 1.0 / 420.0
	noise.fractal_octaves = 4
	var edge: PackedVector2Array = _edge_of(p_field)
	var mean: float = 0.0
	for place: Vector2 in edge:
		mean += p_field.height_at(place.x, place.y) / edge.size()
	var points: PackedVector3Array = []
	for ring: int in RINGS + 1:
		var part: float = pow(float(ring) / RINGS, 2.2)
		for place: Vector2 in edge:
			var out: Vector2 = place + place.normalized() * (HILLS_M * part)
			var away: float = HILLS_M * part
			var wild: float = noise.get_noise_2d(out.x, out.y)
			var hill: float = mean + wild * minf(away * 0.05, 12.0)
			hill += maxf(wild + 0.15, 0.0) * smoothstep(250.0, 1300.0, away) * 75.0
			var own: float = p_field.height_at(place.x, place.y)
			points.append(Vector3(out.x, lerpf(own, hill, smoothstep(0.0, 90.0, away)), out.y))
	return _wrap(points, edge.size())


## The ground with points so far apart, m: arrays of a mesh ([enum Mesh.ArrayType]), for baking
## light and for navigation meshes.
static func make_coarse(p_field: HeightField, p_step_m: float) -> Array:
	var size: Vector2 = p_field.size()
	var columns: int = maxi(roundi(size.x / p_step_m), 1)
	var rows: int = maxi(roundi(size.y / p_step_m), 1)
	var points: PackedVector3Array = []
	var normals: PackedVector3Array = []
	var index: PackedInt32Array = []
	for row: int in rows + 1:
		for column: int in columns + 1:
			var at: Vector2 = (
				(Vector2(column, row) / Vector2(columns, rows) - Vector2.ONE / 2.0) * size
			)
			points.append(Vector3(at.x, p_field.height_at(at.x, at.y), at.y))
			normals.append(p_field.normal_at(at.x, at.y))
			if row < rows and column < columns:
				var first: int = row * (columns + 1) + column
				var below: int = first + columns + 1
				index.append_array([first, first + 1, below, first + 1, below + 1, below])
	var arrays: Array = []
	arrays.resize(Mesh.ARRAY_MAX)
	arrays[Mesh.ARRAY_VERTEX] = points
	arrays[Mesh.ARRAY_NORMAL] = normals
	arrays[Mesh.ARRAY_INDEX] = index
	return arrays


## Number of a skirt's point: those of the grid's border, in the order of rows.
static func _skirt(p_column: int, p_row: int) -> int:
	var side: int = CELLS + 1
	if p_row == 0:
		return side * side + p_column
	if p_row == CELLS:
		return side * side + side + 2 * (CELLS - 1) + p_column
	return side * side + side + 2 * (p_row - 1) + (1 if p_column == CELLS else 0)


static func _indices(p_step: int) -> PackedInt32Array:
	var index: PackedInt32Array = []
	var side: int = CELLS + 1
	for row: int in range(0, CELLS, p_step):
		for column: int in range(0, CELLS, p_step):
			var first: int = row * side + column
			var below: int = first + p_step * side
			index.append_array([first, first + p_step, below])
			index.append_array([first + p_step, below + p_step, below])
	for place: int in range(0, CELLS, p_step):
		var next: int = place + p_step
		_add_skirt(index, Vector2i(next, 0), Vector2i(place, 0))
		_add_skirt(index, Vector2i(place, CELLS), Vector2i(next, CELLS))
		_add_skirt(index, Vector2i(0, place), Vector2i(0, next))
		_add_skirt(index, Vector2i(CELLS, next), Vector2i(CELLS, place))
	return index


static func _add_skirt(p_index: PackedInt32Array, p_from: Vector2i, p_to: Vector2i) -> void:
	var side: int = CELLS + 1
	var from: int = p_from.y * side + p_from.x
	var to: int = p_to.y * side + p_to.x
	var below: int = _skirt(p_from.x, p_from.y)
	var below_to: int = _skirt(p_to.x, p_to.y)
	p_index.append_array([from, below_to, to, from, below, below_to])


## Places along the edge, around it, in the order in which faces look upwards.
static func _edge_of(p_field: HeightField) -> PackedVector2Array:
	var half: Vector2 = p_field.size() / 2.0
	var corners: PackedVector2Array = [
		Vector2(-half.x, -half.y), Vector2(half.x, -half.y), half, Vector2(-half.x, half.y)
	]
	var places: PackedVector2Array = []
	for corner: int in 4:
		var from: Vector2 = corners[corner]
		var to: Vector2 = corners[(corner + 1) % 4]
		var count: int = maxi(ceili(from.distance_to(to) / HILLS_STEP_M), 1)
		for index: int in count:
			places.append(from.lerp(to, float(index) / count))
	return places


## A mesh of rings of points, the last joined to the first.
static func _wrap(p_points: PackedVector3Array, p_count: int) -> ArrayMesh:
	var index: PackedInt32Array = []
	var normals: PackedVector3Array = []
	normals.resize(p_points.size())
	for ring: int in p_points.size() / p_count - 1:
		for place: int in p_count:
			var a: int = ring * p_count + place
			var b: int = ring * p_count + (place + 1) % p_count
			for face: PackedInt32Array in [
				PackedInt32Array([a, a + p_count, b]),
				PackedInt32Array([b, a + p_count, b + p_count])
			]:
				index.append_array(face)
				var normal: Vector3 = (p_points[face[1]] - p_points[face[0]]).cross(
					p_points[face[2]] - p_points[face[0]]
				)
				for corner: int in face:
					normals[corner] -= normal
	for point: int in normals.size():
		normals[point] = normals[point].normalized()
	var arrays: Array = []
	arrays.resize(Mesh.ARRAY_MAX)
	arrays[Mesh.ARRAY_VERTEX] = p_points
	arrays[Mesh.ARRAY_NORMAL] = normals
	arrays[Mesh.ARRAY_INDEX] = index
	var mesh: ArrayMesh = ArrayMesh.new()
	mesh.add_surface_from_arrays(Mesh.PRIMITIVE_TRIANGLES, arrays)
	return mesh
