class_name LevelOrders
extends RefCounted
## Changes of level that instructors ask for. Each stops the world for some ticks, so that they come
## rarely: see [MessageRates]. Until a change may begin, the last level that was asked for counts.

## Time between two searches for a level that may not exist, s: each reads folders.
const LOOK_S: float = 0.25

var _level: ServerLevel = null
var _rates: MessageRates = null
var _asked: Asked = null
var _looked_s: float = -INF
## Of the change that is going on.
var _loading: String = ""
var _loading_for: Array[Callable] = []
var _began_msec: int = 0


## A level that is wanted.
class Asked:
	var name: String = ""
	var reply: Callable = Callable()


func _init(p_level: ServerLevel, p_rates: MessageRates) -> void:
	_level = p_level
	_rates = p_rates
	_level.change_ended.connect(_on_ended)


## An instructor asks for a level at a time, s.
## [code]func(outcome: AnswerMessage.Outcome, text: String) -> void[/code] gets the answers.
func ask(p_name: String, p_reply: Callable, p_now_s: float) -> void:
	var fault: String = _level.find_fault(p_name)
	if fault != "":
		p_reply.call(AnswerMessage.Outcome.FAILED, fault)
		return
	if _asked != null:
		_asked.reply.call(
			AnswerMessage.Outcome.FAILED,
			"world '%s': '%s' was asked for after it" % [_asked.name, p_name]
		)
		_asked = null
	if _loading == p_name:
		# It is on its way: what was asked for in between is not wanted any more.
		_loading_for.append(p_reply)
		return
	_asked = Asked.new()
	_asked.name = p_name
	_asked.reply = p_reply
	advance(p_now_s)
	if _asked == null:
		return
	var wait_s: float = _rates.wait_of_all_s(&"level", p_now_s)
	var what: String = "world '%s' comes after what is being loaded" % p_name
	if wait_s > 0.0:
		what = "world '%s' comes in %d s: a change in %.0f s is the most"
		what = what % [p_name, ceili(wait_s), 1.0 / MessageRates.ROWS[&"level"][3]]
	p_reply.call(AnswerMessage.Outcome.BEGUN, what)


## Begins a change that may begin, at a time, s. Call it once a tick.
func advance(p_now_s: float) -> void:
	var is_due: bool = _asked != null and _loading == "" and p_now_s - _looked_s >= LOOK_S
	if not is_due or _level.is_changing() or _rates.wait_of_all_s(&"level", p_now_s) > 0.0:
		return
	_looked_s = p_now_s
	var asked: Asked = _asked
	_asked = null
	var fault: String = _level.change_level(asked.name)
	if fault != "":
		asked.reply.call(AnswerMessage.Outcome.FAILED, fault)
		return
	_rates.take_of_all(&"level", p_now_s)
	_loading = asked.name
	_loading_for = [asked.reply]
	_began_msec = Time.get_ticks_msec()
	Log.info("server", "loading world '%s'" % _loading)


func _on_ended(p_fault: String) -> void:
	var seconds: float = (Time.get_ticks_msec() - _began_msec) / 1000.0
	var parts: Array = [_loading, seconds, _level.longest_usec / 1000.0]
	var text: String = "world '%s' is there after %.1f s (%.1f ms of a tick at most)" % parts
	Log.info("server", text if p_fault == "" else p_fault)
	var answer: String = "the world is now '%s'" % _loading
	var outcome: AnswerMessage.Outcome = AnswerMessage.Outcome.DONE
	if p_fault != "":
		answer = p_fault
		outcome = AnswerMessage.Outcome.FAILED
	var replies: Array[Callable] = _loading_for
	_loading = ""
	_loading_for = []
	for reply: Callable in replies:
		reply.call(outcome, answer)
