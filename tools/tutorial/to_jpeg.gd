extends SceneTree
## Makes a JPEG of each PNG of a folder, in its place: [code]-s to_jpeg.gd -- FOLDER[/code].

const QUALITY: float = 0.85


func _initialize() -> void:
	var folder: String = OS.get_cmdline_user_args()[0]
	var error: Error = OK
	for file: String in DirAccess.get_files_at(folder):
		if file.get_extension() != "png":
			continue
		var path: String = folder.path_join(file)
		var fault: Error = Image.load_from_file(path).save_jpg(
			path.get_basename() + ".jpg", QUALITY
		)
		if fault == OK:
			fault = DirAccess.remove_absolute(path)
		error = fault if fault != OK else error
	quit(error)
