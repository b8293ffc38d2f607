extends TestCase
## Somebody who walks without a suit, at the server: a body in physics that goes where the walker
## goes, falls, gets up and walks on.

const WalkerBody: GDScript = preload("res://tests/bench/walker/walker_body.gd")
const WalkerCourse: GDScript = preload("res://tests/bench/walker/walker_course.gd")
const MadeSets: GDScript = preload("res://tests/walker/made_sets.gd")

var _course: WalkerCourse = null
var _body: WalkerBody = null


func before_each() -> void:
	_course = WalkerCourse.new(5, self)
	await physics_frames(2)
	_body = WalkerBody.new(_course.view, WalkerCourse.OPEN)


func after_each() -> void:
	_body.free_all()
	_course.view.queue_free()
	await process_frames(2)


func test_the_body_walks_where_the_walker_does() -> void:
	await _advance(60, Vector2.ZERO)
	await _advance(180, Vector2(0.0, 1.5))
	var walker: Vector3 = _body.walker.mover.get_position()
	is_true(walker.z > WalkerCourse.OPEN.z + 3.0, str(walker))
	var apart: Vector3 = _body.person.hips() - walker
	is_true(apart.y > 0.8, "it stands: %s" % apart)
	is_true(_body.distances.mean() < 0.1, "%.3f m off" % _body.distances.mean())
	await _advance(150, Vector2(0.0, 3.2))
	is_true(_body.distances.mean() < 0.15, "%.3f m off" % _body.distances.mean())
	equal(_body.down_ticks, 0)


func test_a_walker_waits_for_a_body_that_something_light_holds() -> void:
	var wall: StaticBody3D = StaticBody3D.new()
	wall.add_child(BenchBodies.box(Vector3(6.0, 2.0, 0.4)))
	wall.position = WalkerCourse.OPEN + Vector3(0.0, 1.0, 2.0)
	_course.view.add_child(wall)
	_body.walker.mover.set_passable(wall.get_rid(), true)
	await _advance(60, Vector2.ZERO)
	await _advance(240, Vector2(0.0, 1.5))
	var waits: int = _body.walker.waits
	var before: Vector3 = _body.walker.mover.get_position()
	await _advance(120, Vector2(0.0, 1.5))
	var after: Vector3 = _body.walker.mover.get_position()
	is_true(absf(after.z - before.z) < 0.15, "%s to %s" % [before, after])
	is_true(_body.walker.waits < waits + 12, "%d ticks put back" % (_body.walker.waits - waits))
	await _advance(40, Vector2(0.0, -1.2))
	is_true(_body.walker.mover.get_position().z < after.z - 0.3, "nothing holds who goes back")


func test_who_crawls_gets_on() -> void:
	await _advance(90, Vector2.ZERO, WalkerMover.PRONE)
	var before: float = _body.person.hips().z
	await _advance(240, Vector2(0.0, 0.6), WalkerMover.PRONE)
	is_true(_body.person.hips().y < 0.4, "it lies")
	is_true(_body.person.hips().z > before + 1.2, "%.2f m" % (_body.person.hips().z - before))


func test_nobody_is_faster_than_people_are() -> void:
	await _advance(60, Vector2.ZERO)
	await _advance(60, Vector2(600.0, 0.0))
	is_true(_body.walker.mover.get_velocity().length() < 5.6)


func test_a_client_that_is_silent_stands_still() -> void:
	await _advance(30, Vector2(0.0, 1.5))
	for _tick: int in 90:
		await physics_frames(1)
		_body.advance_silent()
	equal(_body.walker.mover.get_velocity(), Vector3.ZERO)


func test_who_wears_a_suit_again_walks_no_more() -> void:
	await _advance(60, Vector2(0.0, 1.5))
	is_false(_body.walker.is_over())
	var worn: PoseSample = PoseSample.new()
	worn.orientations = _body.person.newest.orientations
	worn.root = _body.person.newest.root
	worn.time_usec = roundi(Time.get_unix_time_from_system() * 1e6)
	_body.person.push_sample(worn, _body.tick / 60.0)
	is_true(_body.walker.is_over())
	_body.walker.end()
	equal(_body.person.ragdoll.motor.leg_push, 0.0)


func test_who_is_shoved_falls_gets_up_and_walks_on() -> void:
	await _advance(90, Vector2.ZERO)
	var chest: RID = _body.person.ragdoll.get_bodies()[Limbs.CHEST]
	PhysicsServer3D.body_apply_central_impulse(chest, Vector3(160.0, 0.0, 0.0))
	var lowest: float = INF
	var ticks: int = 0
	await _advance(60, Vector2(0.0, 1.5))
	equal(_body.walker.mover.get_mode(), WalkerMover.BODY as int, "physics has the body")
	while _body.walker.mover.get_mode() == WalkerMover.BODY and ticks < 400:
		ticks += 1
		await _advance(1, Vector2.ZERO)
		lowest = minf(lowest, _body.person.hips().y)
		var apart: Vector3 = _body.person.hips() - _body.walker.mover.get_position()
		is_true(Vector2(apart.x, apart.z).length() < 0.3, "the walker follows: %s" % apart)
	is_true(ticks < 240, "up after %d ticks" % ticks)
	is_true(lowest < 0.5, "it lay: %.2f m" % lowest)
	var from: Vector3 = _body.person.hips()
	await _advance(120, Vector2(0.0, 1.5))
	is_true(_body.person.hips().z - from.z > 1.0)


func test_who_gets_another_gait_walks_on() -> void:
	await _advance(120, Vector2(0.0, 1.4))
	equal(_body.walker.set_id, WalkerSet.SHIPPED)
	var own: WalkerSet = WalkerSet.read(MadeSets.small())
	_body.walker.use_set(own)
	equal(_body.walker.set_id, own.id)
	var last: Vector3 = _body.person.hips()
	for _tick: int in 120:
		await _advance(1, Vector2(0.0, 1.4))
		var step: Vector3 = _body.person.hips() - last
		is_true(step.length() < 0.06, "a step of %s" % step)
		last = _body.person.hips()
	_body.walker.use_set(null)
	equal(_body.walker.set_id, WalkerSet.SHIPPED)
	await _advance(60, Vector2(0.0, 1.4))
	equal(_body.down_ticks, 0)
	is_true(_body.distances.mean() < 0.15, "%.3f m off" % _body.distances.mean())


func _advance(
	p_ticks: int, p_wish: Vector2, p_stance: WalkerMover.Stance = WalkerMover.STAND
) -> void:
	for _tick: int in p_ticks:
		await physics_frames(1)
		var input: WalkerInput = WalkerInput.new()
		input.wish = p_wish
		input.stance = p_stance
		_body.advance(input)
