class_name RoomProbe
extends RefCounted
## Estimates by a few rays how large and how hard the room around a position is: what reverberation
## needs.

## Length of the rays, m: one that meets nothing is open.
const REACH_M: float = 45.0
## Range of the reverberation times, s.
const MIN_TIME_S: float = 0.25
const MAX_TIME_S: float = 6.0
## Share of the rays that must meet something for a position to count as a room.
const ENCLOSED: float = 0.6
## Directions of the rays: corners and faces of a cube.
const _DIRECTIONS: Array[Vector3] = [
	Vector3.UP,
	Vector3.LEFT,
	Vector3.FORWARD,
	Vector3.RIGHT,
	Vector3.BACK,
	Vector3(0.577, 0.577, 0.577),
	Vector3(-0.577, 0.577, 0.577),
	Vector3(-0.577, 0.577, -0.577),
	Vector3(0.577, 0.577, -0.577),
	Vector3.DOWN,
	Vector3(0.688, -0.229, 0.688),
	Vector3(-0.688, -0.229, -0.688),
]

## Share of the rays that met something, 0 to 1.
var enclosure: float = 0.0
## How far sound goes between two walls on average, m.
var mean_path_m: float = REACH_M
## Mean share of the sound that the walls swallow, 0 to 1.
var absorption: float = 0.1
## Absorption of a collider at a position, 0 to 1: [code]func(collider: Object, place: Vector3) ->
## float[/code]; none: 0.1 everywhere.
var absorption_of: Callable = Callable()

var _distances: PackedFloat32Array = []
var _swallowed: PackedFloat32Array = []
var _next: int = 0
var _query: PhysicsRayQueryParameters3D = PhysicsRayQueryParameters3D.new()


func _init() -> void:
	_query.collision_mask = PhysicsLayers.STATIC
	_distances.resize(_DIRECTIONS.size())
	_distances.fill(INF)
	_swallowed.resize(_DIRECTIONS.size())
	_swallowed.fill(1.0)


## Sends the next rays from a position, m; after 12 of them all directions are known.
func look(p_space: PhysicsDirectSpaceState3D, p_place: Vector3, p_rays: int = 1) -> void:
	for _ray: int in p_rays:
		_query.from = p_place
		_query.to = p_place + _DIRECTIONS[_next] * REACH_M
		var hit: Dictionary = p_space.intersect_ray(_query)
		_distances[_next] = INF
		_swallowed[_next] = 1.0
		if not hit.is_empty():
			var at: Vector3 = hit["position"]
			_distances[_next] = maxf(p_place.distance_to(at), 0.1)
			_swallowed[_next] = 0.1
			if absorption_of.is_valid() and is_instance_valid(hit["collider"]):
				var share: float = absorption_of.call(hit["collider"], at)
				_swallowed[_next] = clampf(share, 0.01, 1.0)
		_next = (_next + 1) % _DIRECTIONS.size()
	_sum_up()


## Whether the position counts as a room.
func is_room() -> bool:
	return enclosure >= ENCLOSED


## How long it takes until a sound has lost 60 dB, s: Sabine's law, with the mean path.
func time_s() -> float:
	# V / S of the law is a quarter of the mean path; open directions swallow all.
	return clampf(0.161 * mean_path_m / 4.0 / maxf(absorption, 0.02), MIN_TIME_S, MAX_TIME_S)


## Strength of the reverberation, 0 to 1: none in the open.
func wetness() -> float:
	return clampf((enclosure - 0.35) / 0.5, 0.0, 1.0) * clampf(time_s() / 2.0, 0.12, 0.45)


## The room size that makes the engine's reverberation last so long: its combs are 31 ms and keep
## 0.7 to 0.98 of a sound each round.
func reverb_size() -> float:
	return clampf((pow(10.0, -3.0 * 0.031 / time_s()) - 0.7) / 0.28, 0.0, 1.0)


func _sum_up() -> void:
	var met: int = 0
	var path: float = 0.0
	var swallowed: float = 0.0
	for ray: int in _distances.size():
		swallowed += _swallowed[ray]
		if is_finite(_distances[ray]):
			met += 1
			path += _distances[ray]
	enclosure = float(met) / _distances.size()
	# From a point in the middle the next wall is half a path away.
	mean_path_m = 2.0 * path / met if met > 0 else REACH_M
	absorption = swallowed / _swallowed.size()
