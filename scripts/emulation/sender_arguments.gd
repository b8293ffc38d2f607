class_name SenderArguments
extends RefCounted
## Reads the command line of a program that plays motion as a stream.


## Puts --name=value of arguments into options that hold their defaults; numbers lie within
## [param p_ranges], those of [param p_whole] have no fraction. Returns what is wrong, or an empty
## text; [param p_command] is how ./run calls the program.
static func read(
	r_options: Dictionary[String, String],
	p_ranges: Dictionary,
	p_whole: PackedStringArray,
	p_command: String,
	p_arguments: PackedStringArray = OS.get_cmdline_user_args()
) -> String:
	for argument: String in p_arguments:
		var name: String = argument.get_slice("=", 0).trim_prefix("--")
		var is_given: bool = argument.begins_with("--") and argument.contains("=")
		if not is_given or not r_options.has(name):
			return "unknown option or no value: '%s'; see ./run %s --help" % [argument, p_command]
		r_options[name] = argument.substr(argument.find("=") + 1)
	for name: String in p_ranges:
		var text: String = r_options[name]
		var limits: Vector2 = p_ranges[name]
		var is_whole: bool = p_whole.has(name)
		var is_number: bool = text.is_valid_int() or (not is_whole and text.is_valid_float())
		# A comparison that NaN fails, too.
		if not is_number or not (text.to_float() >= limits.x and text.to_float() <= limits.y):
			return "--%s is %d to %d, found '%s'" % [name, limits.x, limits.y, text]
	return ""
