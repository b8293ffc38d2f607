class_name SessionRecorder
extends ClientPart
## Records what the client receives, if the options ask for it, for a replay.

var _recorder: StateRecorder = null


func begin() -> String:
	if context.options.file("record") == "":
		return ""
	_recorder = StateRecorder.new()
	context.stream.received.connect(
		func(bytes: PackedByteArray, _time_s: float) -> void: _recorder.add(bytes)
	)
	context.stream.restarted.connect(_recorder.begin)
	return _recorder.open(context.fresh_file.call(context.options.file("record")))


func close() -> void:
	if _recorder != null:
		_recorder.close()
