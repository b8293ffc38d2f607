extends SceneTree
## Checks a layout file of a station, and prints what it holds as a JSON object.
##
## [codeblock lang=text]
## godot --headless --path . -s scripts/display/wall/wall_info.gd -- FILE [NAME,...]
## [/codeblock]
## With names, only these screens are on this machine.
## Exit code 0; 2 with what is wrong on the error output, a line each.


func _initialize() -> void:
	var arguments: PackedStringArray = OS.get_cmdline_user_args()
	if arguments.is_empty() or arguments.size() > 2:
		printerr("usage: wall_info FILE [NAME,...]")
		quit(2)
		return
	var layout: WallLayout = LayoutReader.read(arguments[0])
	if not layout.faults.is_empty():
		printerr(layout.describe_faults())
		quit(2)
		return
	var names: PackedStringArray = []
	for screen: WallScreen in layout.screens:
		names.append(screen.name)
	# Their clients are started side by side, on one desktop.
	var fault: String = layout.keep_only(arguments[1] if arguments.size() == 2 else "")
	var shared: PackedStringArray = layout.find_shared_pixels()
	if fault != "" or not shared.is_empty():
		printerr(fault if fault != "" else "\n".join(shared))
		quit(2)
		return
	print(JSON.stringify({"screens": names, "clients": "each" if layout.is_split else "one"}))
	quit(0)
