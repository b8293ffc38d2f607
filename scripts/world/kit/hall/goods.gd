class_name Goods
extends RefCounted
## Pallets and what lies on them: boxes, sacks, drums and crates, chosen by dice.

## A pallet's length, height and depth, m.
const PALLET: Vector3 = Vector3(1.2, 0.144, 0.8)
const _WOOD: SurfaceLayers.Layer = SurfaceLayers.Layer.WOOD
const _BOARD: SurfaceTints.Tint = SurfaceTints.Tint.CREAM
const _FRAME: SurfaceTints.Tint = SurfaceTints.Tint.OCHRE
const _BOXES: Array[int] = [
	SurfaceTints.Tint.TAN,
	SurfaceTints.Tint.STRAW,
	SurfaceTints.Tint.OCHRE,
	SurfaceTints.Tint.TRIM_BROWN,
]
const _DRUMS: Array[int] = [
	SurfaceTints.Tint.BLUE,
	SurfaceTints.Tint.RED,
	SurfaceTints.Tint.DARK_GREEN,
	SurfaceTints.Tint.ORANGE,
]


## Adds an empty pallet around a point.
static func add_pallet(p_mesh: BlockMesh, p_at: Vector3) -> void:
	var half: Vector3 = PALLET / 2.0
	for x: float in [-half.x, -0.07, half.x - 0.14]:
		for z: float in [-half.z, -0.05, half.z - 0.1]:
			var foot: Vector3 = p_at + Vector3(x, 0.0, z)
			p_mesh.box(foot, foot + Vector3(0.14, 0.1, 0.1), _WOOD, _BOARD)
	for board: int in 5:
		var z: float = lerpf(-half.z, half.z - 0.12, board / 4.0)
		var low: Vector3 = p_at + Vector3(-half.x, 0.12, z)
		p_mesh.box(low, low + Vector3(PALLET.x, 0.024, 0.12), _WOOD, _BOARD)
	for x: float in [-half.x, -0.07, half.x - 0.14]:
		var low: Vector3 = p_at + Vector3(x, 0.1, -half.z)
		p_mesh.box(low, low + Vector3(0.14, 0.02, PALLET.z), _WOOD, _BOARD)


## Adds a pallet with a load of a height (m) at most; returns the height of both.
static func add_load(
	p_mesh: BlockMesh, p_at: Vector3, p_high: float, p_dice: RandomNumberGenerator
) -> float:
	add_pallet(p_mesh, p_at)
	var top: Vector3 = p_at + Vector3.UP * PALLET.y
	var high: float = p_high - PALLET.y
	match p_dice.randi_range(0, 4):
		0:
			return PALLET.y + _add_sacks(p_mesh, top, high, p_dice)
		1:
			return PALLET.y + _add_drums(p_mesh, top, p_dice)
		2:
			return PALLET.y + _add_crate(p_mesh, top, minf(high, 0.9))
	return PALLET.y + _add_boxes(p_mesh, top, high, p_dice)


## A crate of boards with a frame of thicker ones and a brace over each side; its bottom's middle is
## the origin.
static func add_crate(p_mesh: BlockMesh, p_size: Vector3, p_tint: int) -> void:
	var edge: float = clampf(p_size.y * 0.14, 0.04, 0.1)
	var thick: float = edge * 0.22
	var half: Vector3 = p_size / 2.0
	var middle: Vector3 = Vector3.UP * half.y
	var inner: Vector3 = half - Vector3.ONE * thick
	p_mesh.box(middle - inner, middle + inner, SurfaceLayers.Layer.PAINTED_WOOD, p_tint)
	var base: Transform3D = p_mesh.get_place()
	for side: int in 6:
		var turn: Basis = Basis(Vector3.UP, PI / 2.0 * side)
		if side >= 4:
			turn = Basis(Vector3.RIGHT, PI / 2.0 if side == 4 else -PI / 2.0)
		var extent: Vector3 = (turn.inverse() * p_size).abs()
		p_mesh.set_place(base * Transform3D(turn, middle))
		_add_side(p_mesh, extent, edge, thick, side < 4)
	p_mesh.set_place(base)


## Layers of boxes with tape on them.
static func _add_boxes(
	p_mesh: BlockMesh, p_at: Vector3, p_high: float, p_dice: RandomNumberGenerator
) -> float:
	var counts: Vector2i = [Vector2i(3, 2), Vector2i(2, 2), Vector2i(4, 2)][p_dice.randi_range(
		0, 2
	)]
	var size: Vector3 = Vector3(1.16 / counts.x, p_dice.randf_range(0.26, 0.38), 0.76 / counts.y)
	var layers: int = clampi(int(p_high / size.y), 1, 4)
	var left_out: int = p_dice.randi_range(0, counts.x)
	for layer: int in layers:
		for number: int in counts.x * counts.y:
			if layer == layers - 1 and layers > 1 and number < left_out:
				continue
			var at: Vector3 = Vector3(number % counts.x, layer, number / counts.x) * size
			var low: Vector3 = p_at + at + Vector3(-0.58, 0.0, -0.38)
			var tint: int = _BOXES[p_dice.randi_range(0, 3)]
			var gap: float = p_dice.randf_range(0.004, 0.016)
			var high: Vector3 = low + size - Vector3(gap, 0.004, gap)
			var hidden: int = BlockMesh.FACE_BOTTOM
			p_mesh.box(low, high, SurfaceLayers.Layer.BURLAP, tint, hidden)
			var middle: float = (low.z + high.z) / 2.0
			var from: Vector3 = Vector3(low.x - 0.001, high.y - 0.09, middle - 0.025)
			var to: Vector3 = Vector3(high.x + 0.001, high.y + 0.001, middle + 0.025)
			var sides: int = hidden | BlockMesh.FACE_FRONT | BlockMesh.FACE_BACK
			p_mesh.box(from, to, Steelwork.PAINT, SurfaceTints.Tint.SAND, sides)
	return layers * size.y


static func _add_sacks(
	p_mesh: BlockMesh, p_at: Vector3, p_high: float, p_dice: RandomNumberGenerator
) -> float:
	const SACK: Vector3 = Vector3(0.58, 0.15, 0.38)
	var layers: int = clampi(int(p_high / SACK.y), 1, 5)
	var tint: int = [SurfaceTints.Tint.PLAIN, SurfaceTints.Tint.WHITE][p_dice.randi_range(0, 1)]
	for layer: int in layers:
		for number: int in 4:
			var x: float = -0.58 + SACK.x * (number % 2) + p_dice.randf_range(-0.02, 0.02)
			var z: float = -0.38 + SACK.z * (number / 2) + SACK.z / 2.0
			var from: Vector3 = p_at + Vector3(x, SACK.y * (layer + 0.5), z)
			_add_sack(p_mesh, from, SACK, tint)
	return layers * SACK.y


## A flat sack: thick in the middle, thin where it is sewn.
static func _add_sack(p_mesh: BlockMesh, p_from: Vector3, p_size: Vector3, p_tint: int) -> void:
	var sack: int = SurfaceLayers.Layer.BURLAP
	for slice: int in 4:
		var wide: float = [1.0, 0.97, 0.97, 1.0][slice]
		var a: float = p_size.x * slice / 4.0
		var high: float = p_size.y * (0.46 if slice == 0 or slice == 3 else 0.53)
		p_mesh.box(
			p_from + Vector3(a, -high, -p_size.z * 0.49 * wide),
			p_from + Vector3(a + p_size.x / 4.0, high, p_size.z * 0.49 * wide),
			sack,
			p_tint
		)


static func _add_drums(p_mesh: BlockMesh, p_at: Vector3, p_dice: RandomNumberGenerator) -> float:
	const HIGH: float = 0.86
	var tint: int = _DRUMS[p_dice.randi_range(0, 3)]
	for x: float in [-0.3, 0.3]:
		var foot: Vector3 = p_at + Vector3(x, 0.0, p_dice.randf_range(-0.08, 0.08))
		p_mesh.rod(foot, foot + Vector3.UP * HIGH, 0.28, 0.28, Steelwork.PAINT, tint, 16)
		for y: float in [0.0, 0.28, 0.57, 0.83]:
			var low: Vector3 = foot + Vector3.UP * y
			p_mesh.rod(low, low + Vector3.UP * 0.03, 0.294, 0.294, Steelwork.PAINT, tint, 16)
	return HIGH


## A crate of boards with a frame.
static func _add_crate(p_mesh: BlockMesh, p_at: Vector3, p_high: float) -> float:
	p_mesh.set_place(p_mesh.get_place().translated_local(p_at))
	add_crate(p_mesh, Vector3(1.1, p_high, 0.74), SurfaceTints.Tint.TAN)
	p_mesh.set_place(p_mesh.get_place().translated_local(-p_at))
	return p_high


## The frame on the side of a crate that looks to +Z.
static func _add_side(
	p_mesh: BlockMesh, p_size: Vector3, p_edge: float, p_thick: float, p_has_brace: bool
) -> void:
	var half: Vector3 = p_size / 2.0
	var back: float = half.z - p_thick
	var hidden: int = BlockMesh.FACE_BACK
	for x: float in [-half.x, half.x - p_edge]:
		p_mesh.box(
			Vector3(x, -half.y, back),
			Vector3(x + p_edge, half.y, half.z),
			SurfaceLayers.Layer.PAINTED_WOOD,
			_FRAME,
			hidden
		)
	var across: float = half.x - p_edge
	var ends: Array[Vector3] = [
		Vector3(-across, p_edge / 2.0 - half.y, 0.0), Vector3(across, p_edge / 2.0 - half.y, 0.0)
	]
	var deep: Vector3 = Vector3(0.0, 0.0, half.z - p_thick / 2.0)
	for y: float in [0.0, p_size.y - p_edge]:
		var up: Vector3 = deep + Vector3.UP * y
		var board: Vector2 = Vector2(p_edge, p_thick)
		_board(p_mesh, ends[0] + up, ends[1] + up, board)
	if p_has_brace:
		var low: Vector3 = Vector3(-across, p_edge * 1.3 - half.y, back + p_thick * 0.4)
		var high: Vector3 = Vector3(across, half.y - p_edge * 1.3, back + p_thick * 0.4)
		_board(p_mesh, low, high, Vector2(p_edge * 0.9, p_thick * 0.7))


## Adds a board along a direction in the plane of a side.
static func _board(p_mesh: BlockMesh, p_from: Vector3, p_to: Vector3, p_size: Vector2) -> void:
	var along: Vector3 = (p_to - p_from).normalized()
	var base: Transform3D = p_mesh.get_place()
	var basis: Basis = Basis(along.cross(Vector3.BACK), along, Vector3.BACK)
	p_mesh.set_place(base * Transform3D(basis, p_from))
	var half: Vector2 = p_size / 2.0
	p_mesh.box(
		Vector3(-half.x, 0.0, -half.y),
		Vector3(half.x, p_from.distance_to(p_to), half.y),
		SurfaceLayers.Layer.PAINTED_WOOD,
		_FRAME,
		BlockMesh.FACE_BACK
	)
	p_mesh.set_place(base)
