class_name MotionInputs
extends RefCounted
## Opens the motion sources that a client's options ask for.

## Somebody's motion can be had now.
signal appeared(p_source: MotionSource, p_name: String)
## Somebody's motion has ended.
signal vanished(p_source: MotionSource)


## Opens all. Returns what is wrong, or an empty text.
func open(p_options: Options) -> String:
	if p_options.text("bvh") == "":
		return "a trainee needs a motion source: --bvh=FILE"
	for path: String in p_options.files("bvh"):
		var source: BvhSource = BvhSource.new()
		source.open(path, p_options.text("unit"), p_options.text("up"))
		if source.error != "":
			return source.error
		Log.info("mocap", source.describe())
		appeared.emit(source, "")
	return ""

