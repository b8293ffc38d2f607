extends TestCase
## The table of how often clients may send what.

var _rates: MessageRates = null


func before_each() -> void:
	_rates = MessageRates.new()


func test_every_order_has_a_rate() -> void:
	for kind: int in OrderMessage.Kind.values():
		is_true(MessageRates.ROWS.has(MessageRates.OF_ORDERS.get(kind)), "order %d" % kind)
	for kind: int in MessageRates.OF_MESSAGES:
		is_true(MessageRates.ROWS.has(MessageRates.OF_MESSAGES[kind]), "message %d" % kind)


func test_the_page_of_the_protocol_has_the_same_numbers() -> void:
	var page: String = FileAccess.get_file_as_string("res://docs/protocol.md")
	var section: String = page.get_slice("### Rates", 1).get_slice("\n## ", 0)
	for what: StringName in MessageRates.ROWS:
		var row: Array = MessageRates.ROWS[what]
		var cells: PackedStringArray = ["`%s`" % what, _number(row[0]), _number(row[1])]
		cells.append("%s, %s" % [_number(row[2]), _number(row[3])] if row[2] > 0 else "")
		contains(section, "| %s |" % " | ".join(cells).replace("|  |", "| |").strip_edges(), what)


func test_all_together_have_a_limit_and_each_has_his_own() -> void:
	var taken: Array[int] = [0, 0, 0]
	for tick: int in 600:
		for session: int in 3:
			taken[session] += 1 if _rates.take(&"fields", session, tick / 60.0) else 0
	var all: int = taken[0] + taken[1] + taken[2]
	is_true(all <= 16 + 80 and all >= 90, "%s" % [taken])
	for number: int in taken:
		is_true(number <= 8 + 40, "%s" % [taken])


func test_what_all_have_used_up_costs_a_session_nothing() -> void:
	while _rates.take_of_all(&"effect", 0.0):
		pass
	for _try: int in 20:
		is_false(_rates.take(&"effect", 1, 0.0))
	is_true(_rates.take(&"effect", 1, 1.0))


func test_a_session_that_has_ended_is_forgotten() -> void:
	while _rates.take(&"who", 1, 0.0):
		pass
	_rates.forget(1)
	is_true(_rates.take(&"who", 1, 0.0))


static func _number(p_number: float) -> String:
	return String.num(p_number, 2).trim_suffix(".0")
