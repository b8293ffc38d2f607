class_name EffectUpdates
extends ClientPart
## Takes the effects that a server sends while a session runs, checks them again, and shows them.
##
## One that is broken changes nothing.

## Effects that were taken over, since the start.
var taken: int = 0
## Effects that were refused, since the start.
var refused: int = 0

var _parts: EffectParts = EffectParts.new()


func open(p_context: ClientContext) -> String:
	super(p_context)
	context.link.joined.connect(_on_joined)
	context.link.handle(Protocol.Message.EFFECT, MessageHandlers.Path.RELIABLE, _on_part)
	return ""


func report() -> Dictionary:
	return {"effects": {"taken": taken, "refused": refused}}


## The effects of the last session are not those of this one. Who comes back gets them again.
func _on_joined() -> void:
	_parts = EffectParts.new()
	EffectLibrary.shared().reset()


func _on_part(p_bytes: PackedByteArray, _arrival_usec: int) -> bool:
	var message: EffectMessage = EffectMessage.decode(p_bytes)
	if message == null:
		return false
	if _parts.take(message):
		_take(message.name, _parts.bytes)
	return true


func _take(p_name: String, p_bytes: PackedByteArray) -> void:
	var file: EffectFile = EffectFile.from_bytes(p_bytes)
	var problems: Array[EffectProblem] = file.problems
	if problems.is_empty():
		problems = EffectLibrary.shared().set_file(p_name, file, true)
	if problems.is_empty():
		taken += 1
		return
	refused += 1
	var parts: Array = [p_name, EffectFile.EXTENSION, problems[0]]
	Log.limited("effects", p_name, "%s.%s of the server is not shown: %s" % parts)
