# SPDX-License-Identifier: MIT
extends SceneTree
## Loads each script named behind "--", so that the engine says what it finds in it: see
## tools/toolchain/script_warnings.py.


func _initialize() -> void:
	var loaded: int = 0
	for path: String in OS.get_cmdline_user_args():
		if load(path) is Script:
			loaded += 1
	print("%d scripts loaded" % loaded)
	quit()
