extends ClientPart
## A part with a message, an option and a line on the screen, as a feature brings it: it greets
## everybody by name. It is listed by the test only.

## Its kind of message: a name, as text.
const KIND: int = 41
const TOPIC: StringName = &"greeting"


static func rows() -> Array[OptionRow]:
	return [OptionRow.text("greet", Roles.names(), "whom to greet")]


func open(p_context: ClientContext) -> String:
	super(p_context)
	if context.options.text("greet").contains("/"):
		return "--greet: a name has no /"
	context.link.handle(KIND, MessageHandlers.Path.RELIABLE, _on_greeted)
	context.link.joined.connect(_greet)
	return ""


func report() -> Dictionary:
	return {"greets": context.options.text("greet")}


func _greet() -> void:
	var bytes: PackedByteArray = [KIND]
	bytes.append_array(context.options.text("greet").to_utf8_buffer())
	context.link.send_reliably(bytes)


func _on_greeted(p_bytes: PackedByteArray, _arrival_usec: int) -> bool:
	context.hud.show_note(
		"Greetings, " + ByteReader.clean(p_bytes.slice(1).get_string_from_utf8()), TOPIC
	)
	return true
