extends TestCase
## Which of the levels that instructors ask for are loaded, and when; time is the test's own.

const DONE: AnswerMessage.Outcome = AnswerMessage.Outcome.DONE
const FAILED: AnswerMessage.Outcome = AnswerMessage.Outcome.FAILED
const BEGUN: AnswerMessage.Outcome = AnswerMessage.Outcome.BEGUN


## Loads nothing.
class FakeLevel:
	extends ServerLevel
	var begun: PackedStringArray = []
	var is_busy: bool = false

	func find_fault(p_name: String) -> String:
		return "there is no world 'nowhere'" if p_name == "nowhere" else ""

	func change_level(p_name: String) -> String:
		begun.append(p_name)
		is_busy = true
		return ""

	func is_changing() -> bool:
		return is_busy

	func finish() -> void:
		is_busy = false
		change_ended.emit("")


var _level: FakeLevel = null
var _orders: LevelOrders = null
## Answers by what was asked for and the number of the question.
var _answers: Dictionary[String, Array] = {}


func before_each() -> void:
	_level = FakeLevel.new()
	_orders = LevelOrders.new(_level, MessageRates.new())
	_answers.clear()


func after_each() -> void:
	_level.free()


func test_two_quick_clicks_lead_to_the_level_that_was_clicked_last() -> void:
	_ask("hall", 0.0)
	_ask("yard", 0.2)
	equal(_level.begun, PackedStringArray(["hall"]))
	equal(_answers["yard"], [BEGUN])
	_level.finish()
	equal(_answers["hall"], [DONE])
	_orders.advance(1.0)
	equal(_level.begun, PackedStringArray(["hall", "yard"]))
	_level.finish()
	equal(_answers["yard"], [BEGUN, DONE])


func test_a_fourth_waits_and_the_last_one_counts() -> void:
	for index: int in 3:
		_ask(["hall", "yard", "hall"][index], index)
		_level.finish()
	for name: String in ["desert", "town", "hangar"]:
		_ask(name, 2.0)
	equal(_level.begun.size(), 3)
	equal([_answers["desert"], _answers["town"]], [[BEGUN, FAILED], [BEGUN, FAILED]])
	_orders.advance(18.0)
	equal(_level.begun.size(), 3)
	_orders.advance(20.1)
	equal(_level.begun[3], "hangar")
	_level.finish()
	equal(_answers["hangar"], [BEGUN, DONE])


func test_the_level_that_is_being_loaded_is_not_loaded_twice() -> void:
	_ask("hall", 0.0)
	_ask("yard", 0.1)
	_ask("hall", 0.2)
	_level.finish()
	equal(_answers["hall"], [DONE, DONE])
	equal(_answers["yard"], [BEGUN, FAILED])
	_orders.advance(20.0)
	equal(_level.begun, PackedStringArray(["hall"]))


func test_a_flood_leads_to_one_change_in_twenty_seconds() -> void:
	for tick: int in 60 * 60:
		var now: float = tick / 60.0
		_orders.advance(now)
		if tick % 3 == 0:
			_ask("hall" if tick % 2 == 0 else "yard", now)
		if _level.is_busy and tick % 10 == 9:
			_level.finish()
	is_true(_level.begun.size() <= 3 + 3, "%d" % _level.begun.size())
	is_true(_level.begun.size() >= 4, "%d" % _level.begun.size())


func test_a_level_that_there_is_not_uses_up_nothing() -> void:
	_ask("nowhere", 0.0)
	equal(_answers["nowhere"], [FAILED])
	for index: int in 2:
		_ask(["hall", "yard"][index], 1.0 + index)
		_level.finish()
	equal(_level.begun, PackedStringArray(["hall", "yard"]))


func _ask(p_name: String, p_now_s: float) -> void:
	_orders.ask(
		p_name,
		func(outcome: AnswerMessage.Outcome, _text: String) -> void:
			_answers.get_or_add(p_name, []).append(outcome),
		p_now_s
	)
