extends "gait_case.gd"
## A random scene, one for each seed: somebody walks on a slope, on rough ground or on stairs among
## loose crates, or does what a clip has, from any moment of it on. Now and then nothing comes from
## the suit.
##
## Many of them are played beside one another in one world.

## For how long it is played, s.
const LENGTH_S: float = 6.0
const _STEEPEST_DEG: float = 30.0
const _MOST_CRATES: int = 12
const _STEPS: int = 10
const _RISE: float = 0.17
const _TREAD: float = 0.29
## A body that is further above what is under it levitates, m.
const _LEVITATION: float = 0.1
## What is seen before this (s) belongs to the beginning.
const _SETTLED_S: float = 0.5
## Clearances are looked for every so many ticks: 50 rays each.
const _LOOKS: int = 6

## Poses of 60 Hz by motion: walks first, then clips.
var motions: Array[Array] = []
## How many of the motions are walks that go ahead, and how many of those climb stairs.
var walks: int = 0
var climbs: int = 0
## Greatest distance of the target from the body, m.
var farthest: float = 0.0
## For how long the body was in the air at most, s.
var aloft_s: float = 0.0
## What the scene is, for who looks into it.
var title: String = ""

var _motion: int = 0
var _from: int = 0
var _stalls_at: float = INF
var _stalls_until: float = INF
var _tick: int = 0
var _aloft: float = 0.0


## Makes ground, crates and the body at a place of a world, m.
func build(p_world: Node3D, p_offset: Vector3) -> void:
	world = Node3D.new()
	world.position = p_offset
	p_world.add_child(world)
	ragdoll = BenchBodies.soldier(root_mode)
	var rise: float = _add_ground()
	_strew_crates(rise)
	_choose_motion()
	enter()


func _add_ground() -> float:
	var kind: float = random.randf()
	if kind < 0.2:
		add_bumps(0.1)
		title = "bumps"
		return 0.0
	if kind < 0.35:
		var up: float = _RISE if random.randf() < 0.5 else -_RISE
		var stairs: Walker = Walker.new(ragdoll.profile)
		stairs.climb(_STEPS, up, _TREAD, 0.6)
		stairs.build_ground(world)
		title = "stairs up" if up > 0.0 else "stairs down"
		return 0.0
	var angle: float = deg_to_rad(random.randf_range(-_STEEPEST_DEG, _STEEPEST_DEG))
	add_floor(angle, 20.0)
	title = "%+.0f deg" % rad_to_deg(angle)
	return tan(angle)


func _strew_crates(p_rise: float) -> void:
	for i: int in random.randi() % (_MOST_CRATES + 1):
		var size: Vector3 = Vector3(
			random.randf_range(0.2, 0.6),
			random.randf_range(0.15, 0.6),
			random.randf_range(0.2, 0.6)
		)
		var place: Vector3 = Vector3(
			random.randf_range(-1.5, 1.5), 0.0, random.randf_range(0.7, 7.0)
		)
		place.y = p_rise * place.z + size.y
		if title == "stairs up":
			place.y += _STEPS * _RISE
		add_crate(size, place, random.randf_range(2.0, 40.0))


func _choose_motion() -> void:
	if title.begins_with("stairs") and random.randf() < 0.5:
		# The wearer climbs them too.
		_motion = 0 if title == "stairs up" else 1
	elif motions.size() == walks or random.randf() < 0.5:
		_motion = random.randi_range(climbs, walks - 1)
		_from = random.randi_range(60, 180) if random.randf() < 0.5 else 0
	else:
		_motion = random.randi_range(walks, motions.size() - 1)
		_from = random.randi() % maxi(motions[_motion].size() - int((LENGTH_S + 1.0) * 60.0), 1)
	_stalls_at = random.randf_range(1.0, 12.0)
	_stalls_until = _stalls_at + random.randf_range(0.2, 1.5)
	title += ", motion %d from tick %d" % [_motion, _from]


## Sends the next pose; the caller drives the motors.
func send() -> void:
	var poses: Array = motions[_motion]
	if time_s < _stalls_at or time_s > _stalls_until:
		var pose: PoseSample = poses[mini(_from + _tick, poses.size() - 1)]
		ragdoll.push_sample(time_s, pose, world.position + Vector3(0.0, 0.95, 0.0))


## Takes the time of a step, and what has come of it.
func note() -> void:
	var delta: float = 1.0 / Engine.physics_ticks_per_second
	time_s += delta
	_tick += 1
	if time_s > _SETTLED_S:
		farthest = maxf(farthest, target_distance())
	if _tick % _LOOKS == 0 and time_s > 2.0 * _SETTLED_S:
		_aloft = _aloft + _LOOKS * delta if clearance() > _LEVITATION else 0.0
		aloft_s = maxf(aloft_s, _aloft)


## How far somebody who walks went ahead, m; 0 for who does not.
func get_ahead() -> float:
	return root_of(ragdoll).z - world.position.z if _motion < walks else 0.0
