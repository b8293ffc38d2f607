extends TestCase
## Turning by steps with a thumbstick.


func test_a_push_is_one_step_to_its_side() -> void:
	var turn: SnapTurn = SnapTurn.new()
	turn.angle = 0.5
	var sum: float = 0.0
	for x: float in [0.0, 0.5, 0.8, 1.0, 1.0, 0.6, 0.5, 0.9]:
		sum += turn.step(Vector2(x, 0.0))
	almost_equal(sum, -0.5, 1e-6, "right is negative, and once")
	sum = 0.0
	for x: float in [0.0, -0.9, 0.0, -0.9]:
		sum += turn.step(Vector2(x, 0.0))
	almost_equal(sum, 1.0, 1e-6)


func test_a_push_ahead_is_no_turn() -> void:
	var turn: SnapTurn = SnapTurn.new()
	equal(turn.step(Vector2(0.7, 0.72)), 0.0)
	equal(turn.step(Vector2(NAN, 0.0)), 0.0)


func test_without_a_step_nobody_turns() -> void:
	var turn: SnapTurn = SnapTurn.new()
	turn.angle = 0.0
	equal(absf(turn.step(Vector2(1.0, 0.0))), 0.0)
