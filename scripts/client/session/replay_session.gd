class_name ReplaySession
extends ClientPart
## Plays a recording instead of a server's world: makes the [RecordedStream] that the options ask
## for.


func open(p_context: ClientContext) -> String:
	super(p_context)
	var options: Options = context.options
	context.stream = RecordedStream.of_file(options.file("file"), options.seconds("from"))
	return ""


func begin() -> String:
	return context.stream.open()


func close() -> void:
	context.stream.close()
