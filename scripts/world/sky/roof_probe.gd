@tool
class_name RoofProbe
extends RefCounted
## Finds the highest surface at points around the eye, by a few rays a tick: rain does not fall
## through roofs, and dust does not swirl in rooms.
##
## The points are a square grid of the whole world that repeats after [constant EDGE_M]: who walks
## on keeps what he has seen.

## Edge of the square around the eye, m.
const EDGE_M: float = 24.0
## Places along the edge.
const SIDE: int = 24
## Rays in a tick.
const RAYS: int = 12
## Height above the eye from which rays go down, m.
const ABOVE_M: float = 25.0
## Height where nothing is found, m.
const NOTHING_M: float = -1000.0

## The heights, one float a point: repeats over the world.
var texture: ImageTexture = null

var _heights: Image = Image.create_empty(SIDE, SIDE, false, Image.FORMAT_RF)
var _next: int = 0


func _init() -> void:
	_heights.fill(Color(NOTHING_M, 0.0, 0.0))
	texture = ImageTexture.create_from_image(_heights)


## Casts the next rays around an eye.
func advance(p_space: PhysicsDirectSpaceState3D, p_eye: Vector3) -> void:
	var cell: float = EDGE_M / SIDE
	var query: PhysicsRayQueryParameters3D = PhysicsRayQueryParameters3D.new()
	query.collision_mask = PhysicsLayers.STATIC
	for _ray: int in RAYS:
		# A large step that visits every point once.
		_next = (_next + 233) % (SIDE * SIDE)
		var column: int = _next % SIDE
		var row: int = _next / SIDE
		var place: Vector3 = Vector3(
			_nearest(column, p_eye.x, cell), p_eye.y, _nearest(row, p_eye.z, cell)
		)
		query.from = place + Vector3.UP * ABOVE_M
		query.to = place + Vector3.DOWN * ABOVE_M
		var hit: Dictionary = p_space.intersect_ray(query)
		var height: float = NOTHING_M
		if not hit.is_empty():
			height = (hit["position"] as Vector3).y
		_heights.set_pixel(column, row, Color(height, 0.0, 0.0))
	texture.update(_heights)


## The height that was found at a position, m.
func height_at(p_place: Vector3) -> float:
	var cell: float = EDGE_M / SIDE
	var column: int = posmod(floori(p_place.x / cell), SIDE)
	var row: int = posmod(floori(p_place.z / cell), SIDE)
	return _heights.get_pixel(column, row).r


## The point with a number that is nearest to the eye.
static func _nearest(p_number: int, p_eye: float, p_cell: float) -> float:
	var middle: float = (p_number + 0.5) * p_cell
	return middle + roundf((p_eye - middle) / EDGE_M) * EDGE_M
