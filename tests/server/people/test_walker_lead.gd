extends TestCase
## Whether a walker's body is where the walker is.

const WalkerCourse: GDScript = preload("res://tests/bench/walker/walker_course.gd")
const WalkerBody: GDScript = preload("res://tests/bench/walker/walker_body.gd")
const TICK_S: float = 1.0 / 60.0
## Hips of somebody who walks are 1.0 m high.
const HIGHEST_M: float = 1.12


func test_a_lead_makes_up_for_what_the_body_loses() -> void:
	var lead: WalkerLead = WalkerLead.new()
	# A body that goes 5 % less far than its motion.
	var body: float = 0.0
	for tick: int in 240:
		lead.advance(Vector3(0.0, 0.0, body - 1.5 * tick * TICK_S), 1.5, false, TICK_S)
		body += (1.5 + lead.velocity.z) * 0.95 * TICK_S
	almost_equal(body, 1.5 * 240 * TICK_S, 0.06)


func test_it_goes_where_the_body_is_missing_until_that_is_there() -> void:
	var lead: WalkerLead = WalkerLead.new()
	# A body that is always 0.2 m behind its motion.
	var off: Vector3 = Vector3.BACK * -0.2
	for tick: int in 300:
		lead.advance(off + lead.lead, 1.5, false, TICK_S)
	almost_equal(lead.lead.z, 0.2, 0.005)
	is_true(lead.velocity.length() < 0.01)


func test_a_lead_is_bounded_and_ends() -> void:
	var lead: WalkerLead = WalkerLead.new()
	for tick: int in 600:
		lead.advance(Vector3(3.0, 9.0, 0.0), 3.0, false, TICK_S)
	almost_equal(lead.lead.length(), WalkerLead.MAX_LEAD, 1e-3)
	equal(lead.lead.y, 0.0)
	is_true(lead.velocity.length() < 1e-3)
	lead.clear()
	equal(lead.lead, Vector3.ZERO)


func test_who_stands_steps_only_where_he_is_off() -> void:
	var lead: WalkerLead = WalkerLead.new()
	for tick: int in 60:
		lead.advance(Vector3(0.1, 0.0, 0.0), 0.0, true, TICK_S)
	equal(lead.lead, Vector3.ZERO)
	for tick: int in 60:
		lead.advance(Vector3(0.2, 0.0, 0.0), 0.0, true, TICK_S)
	is_true(lead.lead.x < -0.05)


func test_bodies_go_along_with_walkers_without_hopping() -> void:
	for wish: String in ["1.5:0:0:9", "0:1:0:9", "-1:0:0:9", "2.4:0:0:9"]:
		var course: WalkerCourse = WalkerCourse.new(9, self)
		await physics_frames(2)
		var body: WalkerBody = WalkerBody.new(course.view, WalkerCourse.OPEN)
		var list: WalkScript = WalkScript.parse(wish)
		var highest: float = 0.0
		for tick: int in 360:
			await physics_frames(1)
			body.advance(WalkerInput.new() if tick < 60 else list.advance(TICK_S))
			highest = maxf(highest, body.person.hips().y)
		equal(body.down_ticks, 0)
		equal(body.walker.waits, 0)
		is_true(body.distances.mean() < 0.15, "%s: %.2f m off" % [wish, body.distances.mean()])
		is_true(rad_to_deg(body.headings.mean()) < 5.0)
		is_true(highest < HIGHEST_M, "%s: hips at %.2f m" % [wish, highest])
		body.free_all()
		course.view.free()
