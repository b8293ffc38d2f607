class_name Tracers
extends RefCounted
## Shows shells and bullets in flight: each client computes their flight from what left the muzzle.

## Most of them at once.
const MAX_SHOWN: int = 48
## Time of flight that the length of a streak shows, s.
const STREAK_S: float = 0.02
## Width of a streak for its calibre, and least of all, m.
const _WIDTH: float = 1.2
const _THIN_M: float = 0.03
## Least width of a streak per metre of distance, so that it can be seen from afar, m/m.
const _WIDEN: float = 0.0011
## Distance from a tracer's path within which a hit ends it, m.
const _NEAR_M: float = 3.0

var _shells: Array[Shell] = []
var _shown: LayeredEffect = null
var _query: PhysicsRayQueryParameters3D = PhysicsRayQueryParameters3D.new()


## Adds what is drawn below [param p_parent], for shots from a body that they do not meet.
func configure(p_parent: Node3D, p_body: CollisionObject3D) -> void:
	_query.collision_mask = PhysicsLayers.ALL
	_query.exclude = [p_body.get_rid()]
	_shown = LayeredEffect.make("tracer")
	_shown.top_level = true
	_shown.visible = false
	p_parent.add_child(_shown)


## One leaves a muzzle.
func add(p_ammunition: Ammunition, p_place: Vector3, p_velocity: Vector3) -> void:
	var flight: ShellFlight = p_ammunition.make_flight()
	if flight == null or not flight.launch(p_place, p_velocity) or _shells.size() >= MAX_SHOWN:
		return
	var shell: Shell = Shell.new()
	shell.ammunition = p_ammunition
	shell.flight = flight
	shell.from = p_place
	_shells.append(shell)


## All fly on by a time, s, seen from a position; [param p_space] is where bullets find what they
## hit, as no event says so.
func advance(p_delta: float, p_eye: Vector3, p_space: PhysicsDirectSpaceState3D) -> void:
	var left: Array[Shell] = []
	for shell: Shell in _shells:
		shell.flight.advance(p_delta)
		var place: Vector3 = shell.flight.get_position()
		var is_stopped: bool = false
		if shell.ammunition.kind == Ammunition.Kind.BULLET:
			_query.from = shell.from
			_query.to = place
			is_stopped = shell.from != place and not p_space.intersect_ray(_query).is_empty()
		shell.from = place
		if not is_stopped and shell.flight.get_age() < Shells.LIFE_S and place.y > Shells.LOWEST_M:
			left.append(shell)
	_shells = left
	_show(p_eye)


## What was fired hits at a position: it is not seen any more. Bullets, of which many fly along one
## path, end by themselves.
func end(p_ammunition: Ammunition, p_place: Vector3) -> void:
	if p_ammunition.kind == Ammunition.Kind.BULLET:
		return
	for shell: Shell in _shells:
		if shell.ammunition != p_ammunition:
			continue
		var ahead: Vector3 = shell.flight.get_velocity().normalized()
		var to: Vector3 = p_place - shell.flight.get_position()
		# It may have flown a part of a frame further, or lag by as much.
		if to.slide(ahead).length() < _NEAR_M:
			_shells.erase(shell)
			return


## How many are in the air.
func count() -> int:
	return _shells.size()


## The effect is where the eye is: it is drawn wherever its bounds are seen.
func _show(p_eye: Vector3) -> void:
	var was_shown: bool = _shown.visible
	_shown.visible = not _shells.is_empty()
	if not (_shown.visible or was_shown):
		return
	_shown.global_position = p_eye
	var heads: PackedVector4Array = []
	var headings: PackedVector4Array = []
	heads.resize(MAX_SHOWN)
	headings.resize(MAX_SHOWN)
	for index: int in _shells.size():
		var shell: Shell = _shells[index]
		var velocity: Vector3 = shell.flight.get_velocity()
		var ahead: Vector3 = velocity.normalized()
		var length: float = minf(STREAK_S, shell.flight.get_age()) * velocity.length()
		var width: float = maxf(shell.ammunition.calibre * _WIDTH, _THIN_M)
		width += p_eye.distance_to(shell.from) * _WIDEN
		heads[index] = Vector4(shell.from.x, shell.from.y, shell.from.z, maxf(length, width))
		headings[index] = Vector4(ahead.x, ahead.y, ahead.z, width)
	_shown.set_input(&"heads", heads)
	_shown.set_input(&"headings", headings)
