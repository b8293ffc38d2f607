extends TestCase
## How far a walker's motion goes ahead so that the body is where the walker is.


func test_it_goes_where_the_body_is_missing_until_that_is_there() -> void:
	var lead: WalkerLead = WalkerLead.new()
	# A body that is always 0.2 m behind its motion.
	var off: Vector3 = Vector3.BACK * -0.2
	for _tick: int in 300:
		lead.advance(off + lead.lead, 1.0 / 60.0)
	almost_equal(lead.lead.z, 0.2, 0.005)
	is_true(lead.velocity.length() < 0.01)


func test_what_holds_the_body_is_not_pulled_at_without_end() -> void:
	var lead: WalkerLead = WalkerLead.new()
	for _tick: int in 600:
		lead.advance(Vector3(-2.0, 1.0, 0.0), 1.0 / 60.0)
		is_true(lead.velocity.length() < WalkerLead.MAX_SPEED + 1e-3)
	almost_equal(lead.lead.length(), WalkerLead.MAX_LEAD, 1e-4)
	equal(lead.lead.y, 0.0)
	lead.clear()
	equal(lead.lead, Vector3.ZERO)
	equal(lead.velocity, Vector3.ZERO)
