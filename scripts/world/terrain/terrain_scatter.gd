@tool
class_name TerrainScatter
extends RefCounted
## Stones and dry bushes on a terrain: seen near by only, without collision, the same on all
## machines.

## How far they are seen, m.
const SIGHT_M: float = 110.0
## Edge of the squares that are shown and hidden together, m.
const SQUARE_M: float = 50.0
## Kinds of stones, and of bushes.
const KINDS: int = 3


## The nodes for the ground of a terrain, with as many stones and bushes a square of 10 or 20 m as
## asked for.
static func make(p_field: HeightField, p_stones: int, p_bushes: int) -> Array[Node3D]:
	var nodes: Array[Node3D] = []
	var dice: RandomNumberGenerator = RandomNumberGenerator.new()
	dice.seed = 8
	var noise: FastNoiseLite = FastNoiseLite.new()
	noise.frequency = 0.017
	var stones: Array[Mesh] = []
	var plants: Array[Mesh] = []
	for kind: int in KINDS:
		stones.append(_make_stone(dice))
		plants.append(_make_bush(dice))
	var material: Material = load("res://assets/world/materials/scatter.tres") as Material
	var half: Vector2 = p_field.size() / 2.0
	for row: int in ceili(p_field.size().y / SQUARE_M):
		for column: int in ceili(p_field.size().x / SQUARE_M):
			var from: Vector2 = Vector2(column, row) * SQUARE_M - half
			# One kind a square: each costs a draw.
			var kind: int = (row * 2 + column) % KINDS
			var many: int = roundi(p_stones * SQUARE_M * SQUARE_M / 100.0)
			var lying: Array[Transform3D] = _throw_stones(p_field, from, many, dice, noise)
			_add(nodes, stones[kind], material, lying, from)
			many = roundi(p_bushes * SQUARE_M * SQUARE_M / 400.0)
			var growing: Array[Transform3D] = _plant(p_field, from, many, dice, noise)
			_add(nodes, plants[kind], material, growing, from)
	return nodes


## Shows as many of a square's stones or bushes as the tier of quality says: see [Quality].
static func show_share(p_square: MultiMeshInstance3D) -> void:
	var count: int = p_square.multimesh.instance_count
	p_square.multimesh.visible_instance_count = ceili(count * Quality.tier.scatter)
	p_square.visibility_range_end = SIGHT_M * (0.5 + 0.5 * Quality.tier.scatter)


static func _throw_stones(
	p_field: HeightField,
	p_from: Vector2,
	p_many: int,
	p_dice: RandomNumberGenerator,
	p_noise: Noise
) -> Array[Transform3D]:
	var places: Array[Transform3D] = []
	for _stone: int in p_many:
		var at: Vector2 = p_from + Vector2(p_dice.randf(), p_dice.randf()) * SQUARE_M
		var luck: float = p_dice.randf()
		var first: int = p_field.index_at(at.x, at.y) * HeightField.PAINTS
		var wish: float = p_field.paint[first + HeightField.Paint.GRAVEL] * 0.003
		wish += p_field.paint[first + HeightField.Paint.ROCK] * 0.002 + 0.008
		if luck > wish + 0.10 or p_field.paint[first + HeightField.Paint.ROAD] > 38:
			continue
		wish += 0.10 * smoothstep(-0.05, 0.3, p_noise.get_noise_2d(at.x, at.y))
		if luck > wish:
			continue
		# Most are small.
		var size: float = 0.05 + 0.42 * pow(p_dice.randf(), 5.0)
		if wish > 0.3:
			size *= 1.3
		var axis: Vector3 = Vector3(p_dice.randf() - 0.5, 1.2, p_dice.randf() - 0.5).normalized()
		var basis: Basis = Basis(axis, p_dice.randf() * TAU).scaled(Vector3.ONE * size)
		var height: float = p_field.height_at(at.x, at.y) - size * p_dice.randf_range(0.1, 0.3)
		places.append(Transform3D(basis, Vector3(at.x - p_from.x, height, at.y - p_from.y)))
	return places


static func _plant(
	p_field: HeightField,
	p_from: Vector2,
	p_many: int,
	p_dice: RandomNumberGenerator,
	p_noise: Noise
) -> Array[Transform3D]:
	var places: Array[Transform3D] = []
	for _bush: int in p_many:
		var at: Vector2 = p_from + Vector2(p_dice.randf(), p_dice.randf()) * SQUARE_M
		var turn: float = p_dice.randf() * TAU
		var size: float = p_dice.randf_range(0.35, 1.0)
		var wish: float = smoothstep(-0.15, 0.35, p_noise.get_noise_2d(at.x + 900.0, at.y))
		wish = maxf(wish, 0.8 * p_field.paint_at(at.x, at.y, HeightField.Paint.CLAY))
		var is_covered: bool = p_field.paint_at(at.x, at.y, HeightField.Paint.ROAD) > 0.1
		is_covered = is_covered or p_field.paint_at(at.x, at.y, HeightField.Paint.ROCK) > 0.4
		if p_dice.randf() > wish or is_covered or p_field.normal_at(at.x, at.y).y < 0.86:
			continue
		var basis: Basis = Basis(Vector3.UP, turn).scaled(Vector3.ONE * size)
		var height: float = p_field.height_at(at.x, at.y) - 0.03
		places.append(Transform3D(basis, Vector3(at.x - p_from.x, height, at.y - p_from.y)))
	return places


static func _add(
	p_nodes: Array[Node3D],
	p_mesh: Mesh,
	p_material: Material,
	p_places: Array[Transform3D],
	p_from: Vector2
) -> void:
	if p_places.is_empty():
		return
	var many: MultiMesh = MultiMesh.new()
	many.transform_format = MultiMesh.TRANSFORM_3D
	many.mesh = p_mesh
	many.instance_count = p_places.size()
	for index: int in p_places.size():
		many.set_instance_transform(index, p_places[index])
	var node: MultiMeshInstance3D = MultiMeshInstance3D.new()
	node.multimesh = many
	node.material_override = p_material
	node.position = Vector3(p_from.x, 0.0, p_from.y)
	show_share(node)
	node.cast_shadow = GeometryInstance3D.SHADOW_CASTING_SETTING_OFF
	p_nodes.append(node)


## A stone of a metre: a ball of few faces, cut by planes.
static func _make_stone(p_dice: RandomNumberGenerator) -> ArrayMesh:
	var ball: SphereMesh = SphereMesh.new()
	ball.radial_segments = 10
	ball.rings = 5
	var arrays: Array = ball.get_mesh_arrays()
	var points: PackedVector3Array = arrays[Mesh.ARRAY_VERTEX]
	var cuts: Array[Plane] = []
	for _cut: int in 9:
		var way: Vector3 = Vector3(p_dice.randfn(), p_dice.randfn(), p_dice.randfn()).normalized()
		cuts.append(Plane(way, p_dice.randf_range(0.26, 0.44)))
	var squash: Vector3 = Vector3(1.0, p_dice.randf_range(0.5, 0.8), p_dice.randf_range(0.7, 1.0))
	for index: int in points.size():
		for cut: Plane in cuts:
			points[index] -= cut.normal * maxf(cut.distance_to(points[index]), 0.0)
		points[index] *= squash
	var shade: float = p_dice.randf_range(0.75, 1.15)
	return _flat(points, arrays[Mesh.ARRAY_INDEX], Color(shade, shade, shade, 1.0))


## Faces with edges: each has points of its own.
static func _flat(
	p_points: PackedVector3Array, p_index: PackedInt32Array, p_color: Color
) -> ArrayMesh:
	var maker: SurfaceTool = SurfaceTool.new()
	maker.begin(Mesh.PRIMITIVE_TRIANGLES)
	for first: int in range(0, p_index.size(), 3):
		var a: Vector3 = p_points[p_index[first]]
		var b: Vector3 = p_points[p_index[first + 1]]
		var c: Vector3 = p_points[p_index[first + 2]]
		var across: Vector3 = (c - a).cross(b - a)
		if across.length() < 1e-6:
			continue
		for point: Vector3 in [a, b, c]:
			# Between the face's and the ball's: edges, but worn ones.
			maker.set_normal((across.normalized() + 0.7 * point.normalized()).normalized())
			maker.set_color(p_color)
			maker.add_vertex(point)
	maker.index()
	return maker.commit()


## A thorn bush of a metre: bent twigs out of one place.
static func _make_bush(p_dice: RandomNumberGenerator) -> ArrayMesh:
	var maker: SurfaceTool = SurfaceTool.new()
	maker.begin(Mesh.PRIMITIVE_TRIANGLES)
	for _twig: int in 46:
		var angle: float = p_dice.randf() * TAU
		var out: Vector3 = (
			Vector3(cos(angle), p_dice.randf_range(0.35, 1.5), sin(angle)).normalized()
		)
		var from: Vector3 = Vector3(p_dice.randf() - 0.5, 0.0, p_dice.randf() - 0.5) * 0.16
		var bend: Vector3 = Vector3(p_dice.randfn(), p_dice.randfn() * 0.4, p_dice.randfn()) * 0.13
		var length: float = p_dice.randf_range(0.25, 0.62)
		var middle: Vector3 = from + out * length * 0.55 + bend * 0.5
		var to: Vector3 = from + out * length + bend
		var width: Vector3 = out.cross(Vector3.UP).normalized() * p_dice.randf_range(0.006, 0.013)
		var tone: Color = Color(0.30, 0.26, 0.16).lerp(Color(0.46, 0.40, 0.24), p_dice.randf())
		tone.a = 0.0
		var normal: Vector3 = (out + Vector3.UP).normalized()
		for point: Vector3 in [
			from - width, from + width, middle - width, from + width, middle + width, middle - width
		]:
			_add_point(maker, point, normal, tone)
		for point: Vector3 in [middle - width, middle + width, to]:
			_add_point(maker, point, normal, tone)
		# Leaves that have dried on the twig.
		var leaf: Color = Color(0.36, 0.34, 0.20).lerp(Color(0.56, 0.49, 0.30), p_dice.randf())
		leaf.a = 0.0
		for _leaf: int in 3:
			var on: Vector3 = middle.lerp(to, p_dice.randf())
			var way: Vector3 = (
				Vector3(p_dice.randfn(), p_dice.randfn(), p_dice.randfn()).normalized()
			)
			var side: Vector3 = way.cross(out).normalized() * 0.020
			for point: Vector3 in [on - side, on + side, on + way * 0.075]:
				_add_point(maker, point, normal, leaf)
	return maker.commit()


static func _add_point(
	p_maker: SurfaceTool, p_point: Vector3, p_normal: Vector3, p_color: Color
) -> void:
	p_maker.set_normal(p_normal)
	p_maker.set_color(p_color)
	p_maker.add_vertex(p_point)
