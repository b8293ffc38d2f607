extends TestCase
## What a server sends is checked again: a broken effect changes nothing.

const LinkPair: GDScript = preload("res://tests/net/link_pair.gd")

var _pair: LinkPair = null
var _updates: EffectUpdates = null


func before_each() -> void:
	_pair = LinkPair.new()
	equal(_pair.listen(), OK)
	_open(_pair.join(Roles.Role.OBSERVER).link)


func after_each() -> void:
	_updates.free()
	_pair.close()
	EffectLibrary.forget()


func test_a_new_text_is_shown() -> void:
	_send("test_fountain", EffectTexts.GOOD)
	is_true(_pair.until(func() -> bool: return _updates.taken == 1))
	equal(EffectLibrary.shared().text_of("test_fountain"), EffectTexts.GOOD)


func test_a_broken_one_changes_nothing() -> void:
	_send("test_fountain", EffectTexts.GOOD)
	for broken: String in [
		EffectTexts.GOOD.replace(";", ""),
		EffectTexts.of("", "while (true) { }"),
		"\u001b[2J",
		"",
	]:
		_send("test_fountain", broken)
	is_true(_pair.until(func() -> bool: return _updates.refused == 4))
	equal(_updates.taken, 1)
	equal(EffectLibrary.shared().text_of("test_fountain"), EffectTexts.GOOD)


func test_a_new_session_begins_with_the_shipped_effects() -> void:
	var shipped: String = EffectLibrary.shared().text_of("smoke")
	for name: String in ["test_fountain", "smoke"]:
		equal(EffectLibrary.shared().set_text(name, EffectTexts.GOOD).size(), 0)
	var link: ClientLink = ClientLink.new()
	_updates.free()
	_open(link)
	link.joined.emit()
	is_false(EffectLibrary.shared().has("test_fountain"))
	equal(EffectLibrary.shared().text_of("smoke"), shipped)


func _open(p_link: ClientLink) -> void:
	var context: ClientContext = ClientContext.new()
	context.link = p_link
	_updates = EffectUpdates.new()
	_updates.open(context)


func _send(p_name: String, p_text: String) -> void:
	for message: PackedByteArray in EffectMessage.split(1, p_name, p_text.to_utf8_buffer()):
		_pair.server.send_whole(_pair.server.session_ids()[0], message)
