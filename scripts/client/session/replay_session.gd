class_name ReplaySession
extends ClientPart
## Plays a recording instead of a server's world: makes the [RecordedStream] that the options ask
## for.

## Frames that take longer than this, s, are those in which a world loads.
const _MAX_STEP_S: float = 0.25


func open(p_context: ClientContext) -> String:
	super(p_context)
	var options: Options = context.options
	var recording: RecordedStream = RecordedStream.of_file(
		options.file("file"), options.seconds("from")
	)
	recording.max_step_s = _MAX_STEP_S
	context.stream = recording
	return ""


func begin() -> String:
	return context.stream.open()


func close() -> void:
	context.stream.close()
