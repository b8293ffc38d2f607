extends TestCase
## Walking by a list.


func test_parts_follow_one_another_and_the_last_one_lasts() -> void:
	var list: WalkScript = WalkScript.parse("1.5:0:0:1,0:1:90:1:crouch,0:0:0:1:jump")
	equal(list.error, "")
	list.begin(0.0)
	var first: WalkerInput = list.advance(0.5)
	almost_equal(first.wish, Vector2(0.0, 1.5))
	var second: WalkerInput = list.advance(0.75)
	equal(second.stance, WalkerMover.CROUCH)
	# It has turned to the left by 90 deg/s for this step, and goes to the right of where it faces.
	almost_equal(second.heading, deg_to_rad(67.5), 1e-4)
	almost_equal(second.wish, WalkerInput.to_world(0.0, 1.0, second.heading), 1e-4)
	is_true(list.advance(5.0).jumps)


func test_right_is_to_the_right() -> void:
	# Who faces +Z has -X to the right.
	almost_equal(WalkerInput.to_world(0.0, 1.0, 0.0), Vector2(-1.0, 0.0))
	almost_equal(WalkerInput.to_world(1.0, 0.0, PI / 2.0), Vector2(1.0, 0.0), 1e-6)


func test_what_is_no_list_is_named() -> void:
	for text: String in [
		"", "1:2", "a:0:0:1", "1:0:0:0", "1:0:0:1:fly", "nan:0:0:1", "1:0:0:1:jump:2"
	]:
		contains(WalkScript.parse(text).error, "--walk is")
