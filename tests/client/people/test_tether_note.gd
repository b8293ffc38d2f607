extends TestCase
## What a wearer reads whose body cannot follow.


func test_it_says_how_far_and_where_the_motion_is() -> void:
	# The body is 1.2 m behind its motion, which is in front of it: the front is +Z.
	equal(
		TetherNote.describe(Vector2(0.0, -1.2), 0.0), "Held back: your motion is 1.2 m ahead of you"
	)
	contains(TetherNote.describe(Vector2(0.0, 3.0), 0.0), "3.0 m behind you")
	contains(TetherNote.describe(Vector2(-0.4, 0.0), 0.0), "0.4 m to your left")
	contains(TetherNote.describe(Vector2(0.4, 0.0), 0.0), "0.4 m to your right")


func test_directions_are_those_of_the_body() -> void:
	# Turned to face +X, where the motion is.
	contains(TetherNote.describe(Vector2(-2.0, 0.0), PI / 2.0), "2.0 m ahead")
	contains(TetherNote.describe(Vector2(0.0, -2.0), PI / 2.0), "to your right")


func test_nothing_is_said_where_the_body_follows() -> void:
	equal(TetherNote.describe(Vector2.ZERO, 1.0), "")
	equal(TetherNote.describe(Vector2(0.05, 0.05), 1.0), "")
