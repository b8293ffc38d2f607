class_name RockMaker
extends RefCounted
## Rocks of layered sandstone: table mountains, needles, boulders, as faces of a [BlockMesh].

## Length of a part of a rock's outline, and height of a row of faces, m.
const PART_M: float = 1.7
const ROW_M: float = 0.85
## Edge of the rock's picture, m.
const EDGE_M: float = 3.0

var _noise: FastNoiseLite = FastNoiseLite.new()
var _layers: FastNoiseLite = FastNoiseLite.new()
var _seed: int = 0


## A table mountain or needle around the origin, its foot some metres below 0. Returns the height of
## its top at the middle, m.
func mesa(p_mesh: BlockMesh, p_radius: float, p_height: float, p_seed: int, p_tint: int) -> float:
	_begin(p_seed)
	var below: float = 4.0 + p_height * 0.1
	var columns: int = maxi(roundi(TAU * p_radius / PART_M), 14)
	var rows: int = maxi(roundi((p_height + below) / ROW_M), 8)
	var grid: Array[PackedVector3Array] = []
	for row: int in rows + 1:
		var line: PackedVector3Array = []
		var y: float = -below + (p_height + below) * row / rows
		for column: int in columns + 1:
			line.append(_wall_point(TAU * (column % columns) / columns, y, p_radius, p_height))
		grid.append(line)
	# The top: rings towards the middle.
	var rings: int = maxi(roundi(p_radius * 0.8 / PART_M), 3)
	for ring: int in range(1, rings + 1):
		var line: PackedVector3Array = []
		var inward: float = 1.0 - float(ring) / rings
		for column: int in columns + 1:
			var edge: Vector3 = grid[rows][column]
			var flat: Vector3 = Vector3(edge.x * inward, 0.0, edge.z * inward)
			var bump: float = _noise.get_noise_3d(flat.x * 2.2, 70.0, flat.z * 2.2)
			var lift: float = p_height * 0.035 * sin(PI * minf(1.0 - inward + 0.1, 0.5))
			flat.y = lerpf(edge.y, p_height + 0.9 * bump, minf(ring * 0.6, 1.0)) + lift
			line.append(flat)
		grid.append(line)
	_add_grid(p_mesh, grid, rows, p_tint)
	return p_height


## A boulder around a place, sunk into the ground by a quarter.
func boulder(p_mesh: BlockMesh, p_place: Vector3, p_size: float, p_seed: int, p_tint: int) -> void:
	_begin(p_seed)
	_noise.frequency = 0.55 / p_size
	var dice: RandomNumberGenerator = RandomNumberGenerator.new()
	dice.seed = p_seed
	var squash: Vector3 = Vector3(
		dice.randf_range(0.8, 1.2), dice.randf_range(0.5, 0.85), dice.randf_range(0.8, 1.1)
	)
	var cuts: Array[Plane] = []
	for _cut: int in 8:
		var way: Vector3 = Vector3(dice.randfn(), dice.randfn() * 0.7, dice.randfn()).normalized()
		cuts.append(Plane(way, dice.randf_range(0.30, 0.46) * p_size))
	var columns: int = clampi(roundi(p_size * 7.0), 9, 18)
	var rows: int = clampi(roundi(p_size * 4.0), 6, 10)
	var grid: Array[PackedVector3Array] = []
	for row: int in rows + 1:
		var line: PackedVector3Array = []
		var tilt: float = PI * row / rows
		for column: int in columns + 1:
			var turn: float = TAU * (column % columns) / columns
			var way: Vector3 = Vector3(sin(tilt) * cos(turn), -cos(tilt), sin(tilt) * sin(turn))
			var point: Vector3 = (
				way * p_size * 0.5 * (1.0 + 0.5 * _noise.get_noise_3dv(way * p_size))
			)
			for cut: Plane in cuts:
				point -= cut.normal * maxf(cut.distance_to(point), 0.0) * 0.9
			line.append(p_place + point * squash + Vector3.UP * p_size * squash.y * 0.22)
		grid.append(line)
	_add_grid(p_mesh, grid, rows + 1, p_tint)


func _begin(p_seed: int) -> void:
	_seed = p_seed
	_noise.seed = p_seed
	_noise.frequency = 0.085
	_noise.fractal_octaves = 4
	_layers.seed = p_seed + 100
	_layers.frequency = 0.33
	_layers.fractal_octaves = 2


## A point of the wall: hard layers stand out, soft ones draw back, gullies run down.
func _wall_point(p_turn: float, p_y: float, p_radius: float, p_height: float) -> Vector3:
	var way: Vector3 = Vector3(cos(p_turn), 0.0, sin(p_turn))
	var outline: float = 1.0 + 0.34 * _noise.get_noise_2d(way.x * 9.0 + 40.0, way.z * 9.0)
	outline += 0.10 * _noise.get_noise_2d(way.x * 31.0, way.z * 31.0 + 80.0)
	var part: float = clampf(p_y / p_height, 0.0, 1.0)
	var dip: float = 0.8 * _noise.get_noise_2d(way.x * 12.0, way.z * 12.0)
	var hard: float = smoothstep(-0.05, 0.05, _layers.get_noise_1d(p_y + dip * 1.2))
	var taper: float = lerpf(1.0, 0.80, part) - 0.10 * smoothstep(0.90, 1.0, part)
	# Debris leans against the foot.
	taper += 0.14 * pow(1.0 - clampf(p_y / (p_height * 0.22), 0.0, 1.0), 2.0)
	var deep: float = minf(p_radius * 0.10, 1.7)
	var reach: float = p_radius * outline * taper + deep * (hard - 0.6)
	var gully: float = absf(_noise.get_noise_3d(way.x * 34.0, p_y * 0.35, way.z * 34.0))
	reach -= (
		minf(p_radius * 0.24, 3.8) * pow(1.0 - minf(gully * 3.2, 1.0), 2.0) * (0.35 + 0.65 * part)
	)
	# Joints: blocks have broken off along upright planes.
	var joint: float = _noise.get_noise_2d(
		floorf(p_turn * p_radius / 3.1) * 37.0, floorf(p_y / 2.6) * 53.0
	)
	reach += minf(p_radius * 0.05, 0.75) * joint * 2.0
	var point: Vector3 = way * reach
	var rough: float = _noise.get_noise_3d(point.x * 5.0, p_y * 5.0, point.z * 5.0)
	return point + way * rough * minf(p_radius * 0.09, 0.9) + Vector3.UP * (p_y + rough * 0.25)


## Faces of a grid whose rows go up the wall and then, from a row on, over the top.
func _add_grid(
	p_mesh: BlockMesh, p_grid: Array[PackedVector3Array], p_top: int, p_tint: int
) -> void:
	var normals: Array[PackedVector3Array] = _normals_of(p_grid)
	for row: int in p_grid.size() - 1:
		var points: PackedVector3Array = []
		var facing: PackedVector3Array = []
		var places: PackedVector2Array = []
		var index: PackedInt32Array = []
		var columns: int = p_grid[row].size() - 1
		var length: float = 0.0
		var around: float = 0.0
		for column: int in columns:
			around += p_grid[row][column].distance_to(p_grid[row][column + 1])
		# The picture meets itself where the outline closes.
		var stretch: float = maxf(roundf(around / EDGE_M), 1.0) * EDGE_M / maxf(around, 0.01)
		for column: int in columns:
			var next: float = length + p_grid[row][column].distance_to(p_grid[row][column + 1])
			var corners: PackedVector3Array = [
				p_grid[row][column],
				p_grid[row][column + 1],
				p_grid[row + 1][column],
				p_grid[row + 1][column + 1]
			]
			var smooth: PackedVector3Array = [
				normals[row][column],
				normals[row][column + 1],
				normals[row + 1][column],
				normals[row + 1][column + 1]
			]
			var face: Vector3 = (
				(corners[3] - corners[0]).cross(corners[1] - corners[2]).normalized()
			)
			for corner: int in 4:
				# Edges, but worn ones.
				points.append(corners[corner])
				facing.append((smooth[corner] + face * 1.1).normalized())
				var at: Vector2 = Vector2((next if corner % 2 == 1 else length) * stretch, 0.0)
				at.y = -corners[corner].y
				places.append(Vector2(corners[corner].x, corners[corner].z) if row >= p_top else at)
			length = next
			var first: int = column * 4
			index.append_array([first, first + 1, first + 2])
			index.append_array([first + 2, first + 1, first + 3])
		p_mesh.surface(points, facing, places, index, SurfaceLayers.Layer.ROCK, p_tint)


static func _normals_of(p_grid: Array[PackedVector3Array]) -> Array[PackedVector3Array]:
	var normals: Array[PackedVector3Array] = []
	for row: int in p_grid.size():
		var line: PackedVector3Array = []
		var columns: int = p_grid[row].size() - 1
		for column: int in columns + 1:
			var left: Vector3 = p_grid[row][posmod(column - 1, columns)]
			var right: Vector3 = p_grid[row][posmod(column + 1, columns)]
			var below: Vector3 = p_grid[maxi(row - 1, 0)][column]
			var above: Vector3 = p_grid[mini(row + 1, p_grid.size() - 1)][column]
			var normal: Vector3 = (above - below).cross(right - left)
			line.append(normal.normalized() if normal.length() > 1e-6 else Vector3.UP)
		normals.append(line)
	return normals
