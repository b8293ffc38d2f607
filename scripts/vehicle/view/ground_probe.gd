class_name GroundProbe
extends RefCounted
## Finds where a vehicle's wheels stand on the level, and on which material: rays against static
## bodies.
##
## A client's own: it costs no bytes on the wire.

## How far above the wheel's lowest point at rest a ray begins, m: higher than any bump it can take.
const _ABOVE_M: float = 0.6
## Greatest vertical speed of a wheel, m/s: at an edge of the ground it does not jump.
const _FOLLOW: float = 2.5

## Greatest travel of a wheel from rest, up (x) and down (y), m.
var travel_m: Vector2 = Vector2(0.16, 0.14)
## How far each wheel is lifted from rest, m.
var lifts: PackedFloat32Array = []
## Whether each wheel touches the ground: 1 or 0.
var touching: PackedByteArray = []
## Where the rays of each wheel met the ground, in the world.
var points: PackedVector3Array = []

var _feet: PackedVector3Array = []
var _query: PhysicsRayQueryParameters3D = PhysicsRayQueryParameters3D.new()
var _body: CollisionObject3D = null
var _colliders: Array[Object] = []


## Takes the lowest point of each wheel at rest, in the vehicle's frame. [param p_body] is the
## vehicle's own body, which no ray meets.
func configure(p_feet: PackedVector3Array, p_body: CollisionObject3D) -> void:
	_feet = p_feet
	_body = p_body
	_query.collision_mask = PhysicsLayers.STATIC
	_query.hit_back_faces = false
	_query.exclude = [p_body.get_rid()] if p_body != null else []
	lifts.resize(p_feet.size())
	touching.resize(p_feet.size())
	points.resize(p_feet.size())
	_colliders.resize(p_feet.size())


## Casts the rays below the vehicle as it stands now.
func advance(p_space: PhysicsDirectSpaceState3D, p_vehicle: Transform3D, p_delta: float) -> void:
	var up: Vector3 = p_vehicle.basis.y
	var step: float = _FOLLOW * p_delta
	for wheel: int in _feet.size():
		var foot: Vector3 = p_vehicle * _feet[wheel]
		_query.from = foot + up * _ABOVE_M
		_query.to = foot - up * travel_m.y
		var hit: Dictionary = p_space.intersect_ray(_query)
		var lift: float = -travel_m.y
		touching[wheel] = 0 if hit.is_empty() else 1
		if not hit.is_empty():
			points[wheel] = hit["position"]
			_colliders[wheel] = hit["collider"]
			lift = clampf(up.dot(points[wheel] - foot), -travel_m.y, travel_m.x)
		lifts[wheel] = move_toward(lifts[wheel], lift, step)


## Lets all wheels be at rest and touch nothing: for vehicles that nobody sees.
func rest() -> void:
	lifts.fill(0.0)
	touching.fill(0)


## What the ground is made of below a wheel that touches it, such as [code]&"sand"[/code].
func surface_of(p_wheel: int) -> StringName:
	var collider: Object = _colliders[p_wheel] if touching[p_wheel] == 1 else null
	if not is_instance_valid(collider):
		return ContactMaterial.NO_KEY
	return StringName(ContactMaterial.at(collider, points[p_wheel]).key)
