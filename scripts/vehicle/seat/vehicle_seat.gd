@tool
@icon("res://scenes/entity/icons/seat.svg")
class_name VehicleSeat
extends Seat
## A seat in or on a [Vehicle]: people climb to it, are held in it by limited forces, and push the
## vehicle as it pushes them.
##
## Its -Z is where its occupant looks. Somebody who stands has the soles at its origin, somebody who
## sits the hips. It may be below the turret.

enum Posture {
	## In a hatch: the hips stay above the seat's floor, as high as the wearer's, the upper body is
	## free.
	STANDING,
	## On a chair, whatever the wearer does: the hips stay, the legs are bent.
	SEATED,
}

## Speed of the vehicle above which nobody can get out, m/s.
const MAX_LEAVING_SPEED: float = 3.0
## Greatest distance of the hips of somebody who sits from the seat's middle, m.
const SEATED_ROOM: float = 0.08

## Height of the hips of somebody who stands beside a chair, m.
const _SITTING_HIPS: float = 0.9

## How it holds people.
@export var posture: Posture = Posture.SEATED
## Whether the occupant is inside: nobody can see or touch the occupant.
@export var is_enclosed: bool = false
## Paths up from the ground: nodes whose children are the positions of the feet, the one on the
## ground first. They do not move in the vehicle's body.
@export var ladders: Array[Node3D] = []
## Height above the seat that feet reach before they go down into it: the height of the roof.
@export_range(0.0, 3.0, 0.01, "suffix:m") var rim: float = 0.0

## Radius of the hatch in which somebody stands.
@export_range(0.0, 1.0, 0.01, "suffix:m") var hatch_radius: float = 0.31
## Height above the roof of what stands around the hatch: periscopes, a ring.
@export_range(0.0, 0.5, 0.01, "suffix:m") var cupola: float = 0.0

@export_group("Hold")
## How far the hips of somebody who stands may be from the middle of the hatch.
@export_range(0.0, 0.5, 0.01, "suffix:m") var room: float = 0.1
## How low somebody who stands can duck: height of the hips above the soles.
@export_range(0.1, 1.5, 0.01, "suffix:m") var lowest_hips: float = 0.3
## And how high the hips can be.
@export_range(0.3, 1.5, 0.01, "suffix:m") var highest_hips: float = 1.08
## Greatest force that carries the person.
@export_range(0.0, 20000.0, 10.0, "suffix:N") var support_force: float = 4000.0
## Greatest force by which somebody holds on so as not to fly up.
@export_range(0.0, 20000.0, 10.0, "suffix:N") var down_force: float = 1200.0
## Greatest force of ring or chair to the sides.
@export_range(0.0, 20000.0, 10.0, "suffix:N") var side_force: float = 4000.0


func _get_configuration_warnings() -> PackedStringArray:
	var warnings: PackedStringArray = super()
	for ladder: Node3D in ladders:
		if ladder == null or ladder.get_child_count() == 0:
			warnings.append("Each of 'Ladders' needs children: the places of the feet.")
	if not (lowest_hips < highest_hips):
		warnings.append("'Lowest Hips' must be below 'Highest Hips'.")
	return warnings


func get_prompt() -> String:
	if is_mine() and find_hindrance() != "":
		return ""
	return super()


func frame_in_body() -> Transform3D:
	return super() * Transform3D(Basis(Vector3.UP, PI), Vector3.ZERO)


func hold() -> SeatHold:
	var made: SeatHold = SeatHold.new()
	made.support_force = support_force
	made.down_force = down_force
	made.side_force = side_force
	made.is_enclosed = is_enclosed
	made.rests_arms = is_enclosed
	if posture == Posture.STANDING:
		made.legs = SeatHold.Legs.STANDING
		made.room = room
		made.lowest = lowest_hips
		made.highest = highest_hips
		made.meets_vehicle = not is_enclosed
		made.rim = rim
		made.cupola = cupola
		made.hatch_radius = 0.0 if is_enclosed else hatch_radius
	else:
		made.legs = SeatHold.Legs.SITTING
		made.room = SEATED_ROOM
		made.lowest = -SEATED_ROOM
		made.highest = SEATED_ROOM
	return made


func mouth() -> Vector3:
	var frame: Transform3D = frame_in_body()
	var is_open: bool = rim <= 0.0 and posture == Posture.SEATED
	return frame.origin + frame.basis.y * (-_SITTING_HIPS if is_open else rim)


func way_in(p_from: Vector3) -> PackedVector3Array:
	var best: PackedVector3Array = PackedVector3Array()
	var nearest: float = INF
	for points: PackedVector3Array in _ladder_points():
		for first: int in points.size():
			var distance: float = points[first].distance_to(p_from)
			if distance < nearest:
				nearest = distance
				best = points.slice(first)
	return best


func way_out(p_is_free: Callable) -> PackedVector3Array:
	var ways: Array[PackedVector3Array] = _ladder_points()
	var top: Vector3 = mouth()
	ways.sort_custom(
		func(p_a: PackedVector3Array, p_b: PackedVector3Array) -> bool:
			return p_a[-1].distance_to(top) < p_b[-1].distance_to(top)
	)
	for way: PackedVector3Array in ways:
		if p_is_free.call(way[0]):
			var down: PackedVector3Array = way.duplicate()
			down.append(top)
			down.reverse()
			return down
	# Where every foot of a ladder is blocked, people get out onto the roof.
	return PackedVector3Array([top, ways[0][-1]]) if not ways.is_empty() else PackedVector3Array()


func neighbours() -> Array[RID]:
	var vehicle: Vehicle = entity.get_body() as Vehicle
	return vehicle.wheel_bodies() if vehicle != null else ([] as Array[RID])


func find_hindrance() -> String:
	var vehicle: Vehicle = entity.get_body() as Vehicle
	if vehicle == null:
		return ""
	var speed: float = vehicle.linear_velocity.length()
	if vehicle.freeze:
		# A client knows what the vehicle says of itself.
		speed = absf(vehicle.state.left_speed + vehicle.state.right_speed) / 2.0
	if speed > MAX_LEAVING_SPEED:
		return "nobody can get out: the vehicle is faster than %d m/s" % roundi(MAX_LEAVING_SPEED)
	return ""


## The points of each ladder that has any, from the ground up, in the body's frame.
func _ladder_points() -> Array[PackedVector3Array]:
	var found: Array[PackedVector3Array] = []
	for ladder: Node3D in ladders:
		var points: PackedVector3Array = PackedVector3Array()
		if ladder == null:
			continue
		for child: Node in ladder.get_children():
			if child is Node3D:
				points.append(ladder.transform * (child as Node3D).position)
		if not points.is_empty():
			found.append(points)
	return found
