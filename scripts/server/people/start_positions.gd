class_name StartPositions
extends RefCounted
## Where people start: at the level's [SpawnPoint]s in turn, further ones in ranks around them, all
## facing as their point does.
##
## Two are never closer than [member spacing], so that outstretched arms do not touch, and nobody
## starts within a wall or a prop, behind a wall, or where there is no floor.

## Abreast in a rank, and ranks at each point.
const ABREAST: int = 9
const RANKS: int = 17
## The room that somebody needs with outstretched arms: size and height of the middle, m.
const ROOM: Vector3 = Vector3(1.9, 1.6, 0.5)
const ROOM_Y: float = 1.1
## Height of the eyes, from which the point must be in sight, and how far above and below the point
## the floor may be, m.
const EYES_Y: float = 1.5
const STEP_Y: float = 0.5

## Distance between two people, m; half of it where a level has no more room.
var spacing: float = 2.5

var _points: Array[Transform3D] = [Transform3D.IDENTITY]
## The avatar that each point is for; empty: all.
var _avatars: PackedStringArray = PackedStringArray([""])
## All positions of the level, in the order in which they are taken, and how many of them have the
## whole distance.
var _positions: PackedVector3Array = PackedVector3Array()
var _wide: int = 0
## The point of each position.
var _point_of: PackedInt32Array = PackedInt32Array()
var _taken: Dictionary[int, Vector3] = {}
var _standing: Dictionary[Vector3, bool] = {}
## Positions that are taken, by squares of [member spacing].
var _squares: Dictionary[Vector2i, Array] = {}
var _room: BoxShape3D = BoxShape3D.new()


func _init() -> void:
	_room.size = ROOM


## Sets the points of another level, m, turned about the vertical only, none for the origin, and
## frees everything. [param p_space] says where floors and walls are; null: there is floor
## everywhere, and nothing else; [param p_avatars] for which avatar each point is, where it is not
## for all. It takes some milliseconds.
func set_points(
	p_points: Array[Transform3D],
	p_space: PhysicsDirectSpaceState3D = null,
	p_avatars: PackedStringArray = []
) -> void:
	_points = p_points.duplicate()
	if _points.is_empty():
		_points.append(Transform3D.IDENTITY)
	_avatars = p_avatars.duplicate()
	_avatars.resize(_points.size())
	_taken.clear()
	_standing.clear()
	_squares.clear()
	_positions.clear()
	_point_of.clear()
	_survey(spacing, p_space)
	_wide = _positions.size()
	_survey(spacing / 2.0, p_space)


## Takes the next free position for somebody, by a number: where it is, m, and which way it faces.
## [param p_space] says which props are in the way; null: none is. Points for [param p_avatar] come
## first, then those for all, then, so that nobody is left out, the others.
func take(p_who: int, p_space: PhysicsDirectSpaceState3D, p_avatar: String = "") -> Transform3D:
	release(p_who)
	var number: int = -1
	if p_avatar != "" and _avatars.has(p_avatar):
		number = _find(p_space, func(avatar: String) -> bool: return avatar == p_avatar)
	if number < 0:
		number = _find(p_space, func(avatar: String) -> bool: return avatar == "")
	if number < 0:
		number = _find(p_space, func(_avatar: String) -> bool: return true)
	# A level without any room: people start inside each other and are pushed apart.
	var found: Transform3D = _points[0]
	if number >= 0:
		found = Transform3D(_points[_point_of[number]].basis, _positions[number])
	_taken[p_who] = found.origin
	_standing[found.origin] = true
	_squares.get_or_add(_square(found.origin), []).append(found.origin)
	return found


## Frees somebody's position.
func release(p_who: int) -> void:
	if _taken.has(p_who):
		var former: Vector3 = _taken[p_who]
		_taken.erase(p_who)
		_standing.erase(former)
		_squares[_square(former)].erase(former)


## The number of the next free position at points whose avatar fits, or -1.
func _find(p_space: PhysicsDirectSpaceState3D, p_fits: Callable) -> int:
	for number: int in _positions.size():
		var position: Vector3 = _positions[number]
		if _standing.has(position) or not p_fits.call(_avatars[_point_of[number]]):
			continue
		if _is_free(position, spacing if number < _wide else spacing / 2.0):
			var turn: Basis = _points[_point_of[number]].basis
			if p_space == null or not _is_in(p_space, position, turn, PhysicsLayers.PROPS):
				return number
	return -1


## Finds the positions at a distance that are none yet.
func _survey(p_spacing: float, p_space: PhysicsDirectSpaceState3D) -> void:
	var known: Dictionary[Vector2i, bool] = {}
	for number: int in ABREAST * RANKS:
		for index: int in _points.size():
			var point: Transform3D = _points[index]
			var position: Vector3 = point * (_offset(number) * p_spacing)
			# Rounded to a quarter of the distance: points close to each other share their
			# positions.
			var square: Vector2i = Vector2i(
				(Vector2(position.x, position.z) / (p_spacing / 4.0)).round()
			)
			if known.has(square):
				continue
			known[square] = true
			if p_space == null or _is_room(p_space, point, position):
				_positions.append(position)
				_point_of.append(index)


## Offsets of the positions at a point, in units of the distance: from the middle of a rank to both
## sides; ranks go behind the point and before it in turn.
static func _offset(p_number: int) -> Vector3:
	return Vector3(_in_turn(p_number % ABREAST), 0.0, -_in_turn(p_number / ABREAST))


## 0, 1, -1, 2, -2 and so on.
static func _in_turn(p_number: int) -> float:
	return (p_number + 1) / 2 * (1.0 if p_number % 2 == 1 else -1.0)


func _is_free(p_position: Vector3, p_distance: float) -> bool:
	var square: Vector2i = _square(p_position)
	for x: int in range(square.x - 1, square.x + 2):
		for y: int in range(square.y - 1, square.y + 2):
			for other: Vector3 in _squares.get(Vector2i(x, y), []):
				if other.distance_to(p_position) < p_distance - 0.001:
					return false
	return true


func _square(p_position: Vector3) -> Vector2i:
	return Vector2i((Vector2(p_position.x, p_position.z) / spacing).floor())


func _is_room(p_space: PhysicsDirectSpaceState3D, p_point: Transform3D, p_at: Vector3) -> bool:
	if p_at == p_point.origin:
		return not _is_in(p_space, p_at, p_point.basis, PhysicsLayers.STATIC)
	var up: Vector3 = Vector3.UP * STEP_Y
	var eyes: Vector3 = Vector3.UP * EYES_Y
	return (
		_is_hit(p_space, p_at + up, p_at - up)
		and not _is_hit(p_space, p_point.origin + eyes, p_at + eyes)
		and not _is_in(p_space, p_at, p_point.basis, PhysicsLayers.STATIC)
	)


## Whether something of some layers is where a person would stand, facing a direction.
func _is_in(
	p_space: PhysicsDirectSpaceState3D, p_position: Vector3, p_turn: Basis, p_layers: int
) -> bool:
	var box: PhysicsShapeQueryParameters3D = PhysicsShapeQueryParameters3D.new()
	box.shape = _room
	box.transform = Transform3D(p_turn, p_position + Vector3.UP * ROOM_Y)
	box.collision_mask = p_layers
	return not p_space.intersect_shape(box, 1).is_empty()


static func _is_hit(p_space: PhysicsDirectSpaceState3D, p_from: Vector3, p_to: Vector3) -> bool:
	var ray: PhysicsRayQueryParameters3D = PhysicsRayQueryParameters3D.create(p_from, p_to)
	ray.collision_mask = PhysicsLayers.STATIC
	return not p_space.intersect_ray(ray).is_empty()
