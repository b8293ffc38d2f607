extends TestCase
## Holding a headset's rate by stepping the quality, in simulated time.

const _PERIOD_S: float = 1.0 / 90.0

var _keeper: RateKeeper = null


func before_each() -> void:
	_keeper = RateKeeper.new()


func test_a_fast_picture_is_left_alone() -> void:
	_play(60.0, func(_step: int) -> int: return 1)
	equal(_keeper.step, 0)
	equal(_keeper.missed, 0)


func test_a_slow_picture_becomes_cheaper_until_it_holds() -> void:
	# Every frame takes two refreshes until the fourth step.
	_play(30.0, func(step: int) -> int: return 2 if step < 3 else 1)
	equal(_keeper.step, 3)
	is_true("80 %" in _keeper.describe(), _keeper.describe())
	is_true(_keeper.missed > 0 and _keeper.missed_share() < 0.15, str(_keeper.missed_share()))


func test_the_quality_comes_back_after_a_quiet_time() -> void:
	_play(10.0, func(step: int) -> int: return 2 if step < 2 else 1)
	equal(_keeper.step, 2)
	_play(10.0, func(_step: int) -> int: return 1)
	equal(_keeper.step, 2, "too early")
	_play(120.0, func(_step: int) -> int: return 1)
	equal(_keeper.step, 0)


func test_a_regretted_step_is_tried_ever_less() -> void:
	var changes: Array[int] = [0]
	_keeper.stepped.connect(func(_step: int) -> void: changes[0] += 1)
	# Ten minutes in which only the second step holds.
	_play(600.0, func(step: int) -> int: return 2 if step < 1 else 1)
	is_true(changes[0] <= 13, "%d changes" % changes[0])
	is_true(_keeper.missed_share() < 0.02, str(_keeper.missed_share()))


func test_rare_spikes_and_pauses_change_nothing() -> void:
	for i: int in 2000:
		_keeper.add(4.0 * _PERIOD_S if i % 300 == 7 else _PERIOD_S, _PERIOD_S)
	_keeper.add(12.0, _PERIOD_S)
	equal(_keeper.step, 0)
	equal(_keeper.missed, 3 * 7, "a spike of four periods misses three refreshes")


func test_one_frame_that_takes_nearly_a_second_changes_nothing() -> void:
	# Such as when somebody joins: every three seconds, for a minute.
	for i: int in 20:
		_play(3.0, func(_step: int) -> int: return 1)
		_keeper.add(0.9, _PERIOD_S)
	equal(_keeper.step, 0)
	equal(_keeper.missed, 20 * 80, "each misses 80 refreshes")


func test_a_few_frames_a_second_are_a_slow_picture() -> void:
	_play(30.0, func(_step: int) -> int: return 36)
	equal(_keeper.step, RateKeeper.STEPS.size() - 1)


func test_what_is_held_up_by_something_else_changes_nothing() -> void:
	for i: int in 400:
		_keeper.add(9.0 * _PERIOD_S, _PERIOD_S, 0.0, true)
	equal(_keeper.step, 0)
	equal(_keeper.missed, 400 * 8)


func test_a_card_without_room_is_not_tried() -> void:
	var changes: Array[int] = [0]
	_keeper.stepped.connect(func(_step: int) -> void: changes[0] += 1)
	_play(600.0, func(step: int) -> int: return 2 if step < 2 else 1, 0.9 * _PERIOD_S)
	equal([_keeper.step, changes[0]], [2, 2])


func test_a_card_with_room_draws_better_soon() -> void:
	_play(10.0, func(step: int) -> int: return 2 if step < 3 else 1, 0.9 * _PERIOD_S)
	equal(_keeper.step, 3)
	_play(10.0, func(_step: int) -> int: return 1, 0.3 * _PERIOD_S)
	is_true(_keeper.step < 3, str(_keeper.step))
	_play(30.0, func(_step: int) -> int: return 1, 0.3 * _PERIOD_S)
	equal(_keeper.step, 0)


func test_the_last_step_is_the_last() -> void:
	_play(60.0, func(_step: int) -> int: return 5)
	equal(_keeper.step, RateKeeper.STEPS.size() - 1)


func test_times_that_are_none_are_left_out() -> void:
	for frame: float in [NAN, INF, -1.0, 0.0]:
		_keeper.add(frame, _PERIOD_S)
	_keeper.add(0.01, 0.0)
	equal(_keeper.frames, 0)


## Plays a time, s; a frame takes as many refreshes as a step of the quality needs, and the card so
## long, s.
func _play(p_seconds: float, p_refreshes: Callable, p_card_s: float = 0.0) -> void:
	var now: float = 0.0
	while now < p_seconds:
		var frame: float = _PERIOD_S * int(p_refreshes.call(_keeper.step))
		_keeper.add(frame, _PERIOD_S, p_card_s)
		now += frame
