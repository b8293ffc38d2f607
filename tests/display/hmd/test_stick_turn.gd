extends TestCase
## Turning by a thumbstick: by steps or smoothly.

const STEP_S: float = 1.0 / 90.0


func test_a_push_is_one_step_to_its_side() -> void:
	var turn: StickTurn = StickTurn.new()
	turn.angle = 0.5
	almost_equal(_sum(turn, [0.0, 0.5, 0.8, 1.0, 1.0, 0.6, 0.5, 0.9]), -0.5, 1e-6, "right, once")
	almost_equal(_sum(turn, [0.0, -0.9, 0.0, -0.9]), 1.0, 1e-6)


func test_a_push_ahead_is_no_turn() -> void:
	for text: String in ["snap", "smooth"]:
		var turn: StickTurn = StickTurn.parse(text)
		equal(turn.advance(Vector2(0.7, 0.72), STEP_S), 0.0)
		equal(turn.advance(Vector2(NAN, 0.0), STEP_S), 0.0)


func test_a_smooth_turn_goes_at_its_rate_and_rests_in_the_middle() -> void:
	var turn: StickTurn = StickTurn.parse("smooth:120")
	var pushed: Array[float] = []
	pushed.resize(90)
	pushed.fill(1.0)
	almost_equal(rad_to_deg(_sum(turn, pushed)), -120.0, 1e-2, "a second to the right")
	pushed.fill(-0.6)
	almost_equal(rad_to_deg(_sum(turn, pushed)), 60.0, 1e-2, "half the way behind the rest zone")
	pushed.fill(0.19)
	equal(absf(_sum(turn, pushed)), 0.0)


func test_none_turns_nobody() -> void:
	equal(StickTurn.parse("none").advance(Vector2(1.0, 0.0), STEP_S), 0.0)


func test_the_option_is_read_and_checked() -> void:
	almost_equal(rad_to_deg(StickTurn.parse("snap").angle), 30.0, 1e-4)
	almost_equal(rad_to_deg(StickTurn.parse("snap:45").angle), 45.0, 1e-4)
	almost_equal(rad_to_deg(StickTurn.parse("smooth").rate), 90.0, 1e-4)
	for text: String in ["", "snap:", "snap:0", "snap:91", "smooth:181", "smooth:nan", "turn:30"]:
		contains(StickTurn.parse(text).error, "found '%s'" % text)
	for text: String in ["snap:30:1", "none:3", "smooth:-90", "snap:inf"]:
		contains(StickTurn.parse(text).error, "found '%s'" % text)


static func _sum(p_turn: StickTurn, p_pushed: Array[float]) -> float:
	var sum: float = 0.0
	for x: float in p_pushed:
		sum += p_turn.advance(Vector2(x, 0.0), STEP_S)
	return sum
