extends SceneTree
## Checks a layout file of a station, and prints what it holds as a JSON object.
##
## [codeblock lang=text]
## godot --headless --path . -s scripts/display/wall/wall_info.gd -- FILE
## [/codeblock]
## Exit code 0; 2 with what is wrong on the error output, a line each.


func _initialize() -> void:
	var arguments: PackedStringArray = OS.get_cmdline_user_args()
	if arguments.size() != 1:
		printerr("usage: wall_info FILE")
		quit(2)
		return
	var layout: WallLayout = WallLayout.read(arguments[0])
	if not layout.faults.is_empty():
		printerr(layout.describe_faults())
		quit(2)
		return
	var names: PackedStringArray = []
	for screen: WallScreen in layout.screens:
		names.append(screen.name)
	print(JSON.stringify({"screens": names, "clients": "each" if layout.is_split else "one"}))
	quit(0)
