class_name FlickerCheck
extends RefCounted
## Whether two surfaces that are not alike lie in each other: the display shows now this one, now
## that one. It knows the tops of level blocks and roads, and terrain.

## Surfaces that are nearer to each other than this flicker, m.
const NEAR_M: float = 0.005
## Least overlap that is reported, m², and, for a block on terrain, as a share of the block.
const MIN_M2: float = 0.1
const MIN_SHARE: float = 0.25
const _PLACES: int = 9


## The upper side of a block.
class Top:
	extends RefCounted
	var node: KitBlock = null
	## Height, m.
	var y: float = 0.0
	## Its corners, seen from above.
	var corners: PackedVector2Array = []
	var box: Rect2 = Rect2()
	## What it looks like: where two that look alike lie in each other, nothing flickers.
	var look: Array = []


var _findings: LevelFindings = null
var _tops: Array[Top] = []


func _init(p_findings: LevelFindings) -> void:
	_findings = p_findings


## Does the work.
func run() -> void:
	var root: Node3D = _findings.level.static_root
	if root == null:
		return
	var terrains: Array[Terrain] = []
	for body: StaticBody3D in _findings.level.get_static_bodies():
		if body is Terrain:
			terrains.append(body)
		var top: Top = _top_of(body)
		if top != null:
			_tops.append(top)
	for terrain: Terrain in terrains:
		for top: Top in _tops:
			_look_at_terrain(terrain, top)
	# From the lowest on, so that only neighbours in height are compared.
	_tops.sort_custom(func(a: Top, b: Top) -> bool: return a.y < b.y)
	for first: int in _tops.size():
		var second: int = first + 1
		while second < _tops.size() and _tops[second].y - _tops[first].y < NEAR_M:
			_look_at_pair(_tops[first], _tops[second])
			second += 1


static func _top_of(p_body: StaticBody3D) -> Top:
	var is_level: bool = p_body.global_basis.y.normalized().is_equal_approx(Vector3.UP)
	if not is_level or not (p_body is Block or p_body is Road):
		return null
	var top: Top = Top.new()
	var area: Rect2 = Rect2()
	var height: float = 0.0
	if p_body is Block:
		var size: Vector3 = (p_body as Block).size
		area = Rect2(-size.x / 2.0, -size.z / 2.0, size.x, size.z)
		height = size.y / 2.0
		var block: Block = p_body as Block
		top.look = [block.surface, block.tint, block.material]
	else:
		var road: Road = p_body as Road
		area = Rect2(-road.size.x / 2.0, -road.size.y, road.size.x, road.size.y)
		height = road.height
		# Markings never lie alike.
		top.look = [road.get_instance_id()]
	top.node = p_body
	for corner: Vector2 in [Vector2(0, 0), Vector2(1, 0), Vector2(1, 1), Vector2(0, 1)]:
		var at: Vector2 = area.position + area.size * corner
		var place: Vector3 = p_body.global_transform * Vector3(at.x, height, at.y)
		top.corners.append(Vector2(place.x, place.z))
		top.y = place.y
	top.box = Rect2(top.corners[0], Vector2.ZERO)
	for corner: Vector2 in top.corners:
		top.box = top.box.expand(corner)
	return top


func _look_at_pair(p_lower: Top, p_upper: Top) -> void:
	if p_lower.look == p_upper.look or not p_lower.box.intersects(p_upper.box):
		return
	var area: float = 0.0
	for common: PackedVector2Array in Geometry2D.intersect_polygons(
		p_lower.corners, p_upper.corners
	):
		area += _area_of(common)
	if area < MIN_M2:
		return
	var text: String = "its top lies in that of '%s', and both flicker: move it up or down by 0.01 m "
	_findings.add_hint(
		LevelFault.Kind.FLICKERS, p_upper.node, text % p_lower.node.name + "or more, or delete one"
	)


func _look_at_terrain(p_terrain: Terrain, p_top: Top) -> void:
	var near: int = 0
	for i: int in _PLACES:
		for j: int in _PLACES:
			var along: Vector2 = Vector2(i + 0.5, j + 0.5) / _PLACES
			var at: Vector2 = p_top.corners[0]
			at += (p_top.corners[1] - p_top.corners[0]) * along.x
			at += (p_top.corners[3] - p_top.corners[0]) * along.y
			var place: Vector3 = Vector3(at.x, p_top.y, at.y)
			if p_terrain.covers(place) and absf(p_terrain.height_at(place) - p_top.y) < NEAR_M:
				near += 1
	if near < MIN_SHARE * _PLACES * _PLACES:
		return
	var text: String = "its top lies in the ground of '%s', and both flicker: delete it, or move it "
	_findings.add_hint(
		LevelFault.Kind.FLICKERS, p_top.node, text % p_terrain.name + "up or down by 0.05 m or more"
	)


static func _area_of(p_corners: PackedVector2Array) -> float:
	var sum: float = 0.0
	for index: int in p_corners.size():
		sum += p_corners[index].cross(p_corners[(index + 1) % p_corners.size()])
	return absf(sum) / 2.0
