class_name HallWall
extends RefCounted
## A wall of a hall in its own frame: from the origin to +X, outside is +Z, corrugated sheet on a
## base of concrete, with framed doors and windows.

const THICK: float = 0.2
const BASE_OUT: float = 0.06
## From here on an opening is a gate with a sliding leaf, m.
const GATE_M: float = 2.5
const _SHEET: SurfaceLayers.Layer = SurfaceLayers.Layer.CORRUGATED
const _PANE_M: float = 1.25

## Length and height, m.
var size: Vector2 = Vector2(10.0, 6.0)
## Height of the base of concrete, m.
var base: float = 1.0
## Openings: x, y, width and height from the lower left corner as seen from outside, m.
var openings: Array[Rect2] = []
## Colours of the sheet outside and inside.
var outside: int = SurfaceTints.Tint.SAGE
var inside: int = SurfaceTints.Tint.WHITE
## Colour of frames and gates.
var frame: int = SurfaceTints.Tint.NAVY

var _mesh: BlockMesh


## Adds the wall to a mesh, at the mesh's present transform.
func build(p_mesh: BlockMesh) -> void:
	_mesh = p_mesh
	_add_sheets()
	_add_base()
	for opening: Rect2 in openings:
		if opening.size.x >= GATE_M and opening.position.y < 0.05:
			_add_gate(opening)
		elif opening.position.y < 0.05:
			_add_frame(opening)
			_add_door(opening)
		else:
			_add_frame(opening)
			_add_panes(opening)
	for rect: Rect2 in solid_rects(size, openings):
		_solid(rect)


## What is left of a wall between its openings, as rectangles.
static func solid_rects(p_size: Vector2, p_openings: Array[Rect2]) -> Array[Rect2]:
	var edges: Array[float] = [0.0, p_size.x]
	for opening: Rect2 in p_openings:
		edges.append(clampf(opening.position.x, 0.0, p_size.x))
		edges.append(clampf(opening.end.x, 0.0, p_size.x))
	edges.sort()
	var rects: Array[Rect2] = []
	for index: int in edges.size() - 1:
		var wide: float = edges[index + 1] - edges[index]
		if wide < 0.01:
			continue
		var middle: float = edges[index] + wide / 2.0
		var over: Array[Rect2] = p_openings.filter(
			func(p_one: Rect2) -> bool: return p_one.position.x < middle and p_one.end.x > middle
		)
		over.sort_custom(
			func(p_a: Rect2, p_b: Rect2) -> bool: return p_a.position.y < p_b.position.y
		)
		var y: float = 0.0
		for opening: Rect2 in over:
			if opening.position.y - y > 0.01:
				rects.append(Rect2(edges[index], y, wide, opening.position.y - y))
			y = maxf(y, opening.end.y)
		if p_size.y - y > 0.01:
			rects.append(Rect2(edges[index], y, wide, p_size.y - y))
	return rects


func _solid(p_rect: Rect2) -> void:
	_mesh.solid(
		Vector3(p_rect.position.x, p_rect.position.y, -THICK),
		Vector3(p_rect.end.x, p_rect.end.y, 0.0)
	)


func _add_sheets() -> void:
	var holes: PackedVector4Array = []
	var back: PackedVector4Array = []
	for opening: Rect2 in openings:
		var at: Vector2 = opening.position
		holes.append(Vector4(at.x, at.y, opening.size.x, opening.size.y))
		back.append(Vector4(size.x - opening.end.x, at.y, opening.size.x, opening.size.y))
	_mesh.face(Vector3.ZERO, Vector3.RIGHT, Vector3.UP, size, _SHEET, outside, holes)
	var far: Vector3 = Vector3(size.x, 0.0, -THICK)
	_mesh.face(far, Vector3.LEFT, Vector3.UP, size, _SHEET, inside, back)


## Concrete between the doors.
func _add_base() -> void:
	var doors: Array[Rect2] = openings.filter(
		func(p_one: Rect2) -> bool: return p_one.position.y < base
	)
	for rect: Rect2 in solid_rects(Vector2(size.x, base), doors):
		var from: Vector3 = Vector3(rect.position.x, rect.position.y, -THICK - BASE_OUT)
		var to: Vector3 = Vector3(rect.end.x, rect.end.y, BASE_OUT)
		_mesh.solid(from, to)
		# In two halves: the ledge indoors would take light from the corners outdoors.
		var concrete: int = SurfaceLayers.Layer.CONCRETE
		var plain: int = SurfaceTints.Tint.PLAIN
		var middle: float = -THICK / 2.0
		var unseen: int = BlockMesh.FACE_BOTTOM | BlockMesh.FACE_FRONT
		_mesh.box(from, Vector3(to.x, to.y, middle), concrete, plain, unseen)
		unseen = BlockMesh.FACE_BOTTOM | BlockMesh.FACE_BACK
		_mesh.box(Vector3(from.x, from.y, middle), to, concrete, plain, unseen)


func _bar(p_rect: Rect2, p_near: float, p_far: float, p_tint: int) -> void:
	_mesh.box(
		Vector3(p_rect.position.x, p_rect.position.y, p_near),
		Vector3(p_rect.end.x, p_rect.end.y, p_far),
		Steelwork.PAINT,
		p_tint
	)


## Steel around an opening, as deep as the wall.
func _add_frame(p_opening: Rect2, p_wide: float = 0.09) -> void:
	var near: float = -THICK - 0.03
	var at: Vector2 = p_opening.position
	var top: Rect2 = Rect2(
		at.x - p_wide, p_opening.end.y - 0.02, p_opening.size.x + 2.0 * p_wide, p_wide
	)
	_bar(top, near, 0.04, frame)
	for x: float in [at.x - p_wide + 0.02, p_opening.end.x - 0.02]:
		_bar(Rect2(x, at.y, p_wide, p_opening.size.y), near, 0.04, frame)
	if at.y > 0.05:
		_bar(Rect2(at.x - 0.05, at.y - 0.06, p_opening.size.x + 0.1, 0.08), near, 0.1, frame)


## Bars between panes so clean that only what they stop is seen of them.
func _add_panes(p_opening: Rect2) -> void:
	var count: int = maxi(1, roundi(p_opening.size.x / _PANE_M))
	var at: Vector2 = p_opening.position
	for pane: int in range(1, count):
		var x: float = at.x + p_opening.size.x * pane / count - 0.025
		_bar(Rect2(x, at.y, 0.05, p_opening.size.y), -0.14, -0.06, frame)
	var middle: Rect2 = Rect2(at.x, p_opening.get_center().y, p_opening.size.x, 0.04)
	_bar(middle, -0.13, -0.07, frame)
	_solid(p_opening)


## A leaf that stands open, outwards.
func _add_door(p_opening: Rect2) -> void:
	var hinge: Vector3 = Vector3(p_opening.position.x, 0.02, 0.04)
	var place: Transform3D = _mesh.get_place()
	var wide: float = p_opening.size.x
	_mesh.set_place(place * Transform3D(Basis(Vector3.UP, -1.95), hinge))
	var top: Vector3 = Vector3(wide, p_opening.size.y - 0.05, 0.025)
	_mesh.box(Vector3(0.0, 0.0, -0.025), top, Steelwork.PAINT, frame, 0, true)
	for y: float in [0.25, 1.2]:
		var low: Vector3 = Vector3(0.14, y, -0.035)
		_mesh.box(
			low, Vector3(wide - 0.14, y + 0.62, 0.035), Steelwork.PAINT, SurfaceTints.Tint.BLUE
		)
	_mesh.rod(
		Vector3(wide - 0.1, 1.02, -0.07),
		Vector3(wide - 0.1, 1.02, 0.07),
		0.02,
		0.02,
		Steelwork.PAINT,
		SurfaceTints.Tint.IRON,
		6
	)
	_mesh.set_place(place)


## A frame with warning stripes, a rail along the inside and the leaf that has been slid aside.
func _add_gate(p_opening: Rect2) -> void:
	_add_frame(p_opening, 0.3)
	for x: float in [p_opening.position.x - 0.3, p_opening.end.x - 0.02]:
		for side: float in [0.045, -THICK - 0.045]:
			_add_stripes(Rect2(x, 0.0, 0.32, 1.8), side)
	var wide: float = p_opening.size.x / 2.0
	var back: float = -THICK - 0.34
	for leaf: int in 2:
		var x: float = p_opening.position.x - wide - 0.2 if leaf == 0 else p_opening.end.x + 0.2
		if x < 0.1 or x + wide > size.x - 0.1:
			continue
		_add_leaf(Rect2(x, 0.04, wide, p_opening.size.y), back)
	var rail: float = p_opening.end.y + 0.12
	var from: float = maxf(0.1, p_opening.position.x - wide - 0.3)
	var to: float = minf(size.x - 0.1, p_opening.end.x + wide + 0.3)
	_bar(Rect2(from, rail, to - from, 0.14), back - 0.02, -THICK, SurfaceTints.Tint.IRON)


func _add_leaf(p_rect: Rect2, p_back: float) -> void:
	var low: Vector3 = Vector3(p_rect.position.x, p_rect.position.y, p_back)
	var high: Vector3 = Vector3(p_rect.end.x, p_rect.end.y, p_back + 0.1)
	_mesh.box(low, high, _SHEET, SurfaceTints.Tint.BLUE, 0, true)
	for y: float in [0.0, p_rect.size.y / 2.0, p_rect.size.y - 0.14]:
		var bar: Rect2 = Rect2(p_rect.position + Vector2(0.0, y), Vector2(p_rect.size.x, 0.14))
		_bar(bar, p_back - 0.04, p_back + 0.14, frame)
	for x: float in [0.0, p_rect.size.x - 0.14]:
		var bar: Rect2 = Rect2(p_rect.position + Vector2(x, 0.0), Vector2(0.14, p_rect.size.y))
		_bar(bar, p_back - 0.04, p_back + 0.14, frame)


## Yellow and black, slanting, in a plane of a depth; they look outwards if it is above 0.
func _add_stripes(p_rect: Rect2, p_z: float) -> void:
	const STEP: float = 0.3
	var y: float = p_rect.position.y
	var is_yellow: bool = true
	while y < p_rect.end.y - 0.05:
		var tint: int = SurfaceTints.Tint.YELLOW if is_yellow else SurfaceTints.Tint.BLACK
		var from: Vector2 = Vector2(p_rect.position.x, y)
		var wide: float = p_rect.size.x
		var a: Vector3 = Vector3(from.x, from.y, p_z)
		var b: Vector3 = Vector3(from.x + wide, from.y + 0.2, p_z)
		var up: Vector3 = Vector3.UP * STEP
		if p_z > 0.0:
			_mesh.quad(b, a, a + up, b + up, Steelwork.PAINT, tint)
		else:
			_mesh.quad(a, b, b + up, a + up, Steelwork.PAINT, tint)
		y += STEP
		is_yellow = not is_yellow
