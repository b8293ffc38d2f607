class_name ReviewScreen
extends ShellScreen
## Opens a recording: one of the program's own folder, or any file.

const _BYTES_OF_MIB: float = 1048576.0

var _list: ItemList = ItemList.new()
var _open: Button = null
var _files: FileDialog = FileDialog.new()
var _paths: PackedStringArray = []


func _init() -> void:
	super("Review a recording")
	_list.size_flags_vertical = Control.SIZE_EXPAND_FILL
	_list.custom_minimum_size.y = 8.0 * UiStyle.BODY_PX
	_list.auto_translate_mode = Node.AUTO_TRANSLATE_MODE_DISABLED
	_list.item_activated.connect(_begin.unbind(1))
	_list.item_selected.connect(_on_selected)
	content.add_child(_list)
	_files.file_mode = FileDialog.FILE_MODE_OPEN_FILE
	_files.access = FileDialog.ACCESS_FILESYSTEM
	_files.add_filter("*." + SessionFiles.EXTENSION, "Recordings")
	_files.file_selected.connect(_begin_file)
	add_child(_files)
	add_answer("Back", closed.emit)
	add_answer("Another file", _choose_file)
	_open = add_answer("Open", _begin)
	_open.theme_type_variation = UiStyle.PRIMARY
	_show_recordings()


func focus_first() -> void:
	if _paths.is_empty():
		find_child("AnotherFile", true, false).call("grab_focus")
	else:
		_list.grab_focus()


func _show_recordings() -> void:
	_paths = SessionFiles.recordings()
	_list.clear()
	for path: String in _paths:
		var size: float = FileAccess.get_size(path) / _BYTES_OF_MIB
		_list.add_item("%s   %.1f MiB" % [path.get_file().get_basename(), size])
	_open.disabled = _paths.is_empty()
	if _paths.is_empty():
		add_text('Sessions that you host with "Record the session" appear here.', UiStyle.HINT)
	else:
		_list.select(0)


func _on_selected(_index: int) -> void:
	_open.disabled = false


func _begin() -> void:
	var selected: PackedInt32Array = _list.get_selected_items()
	if not selected.is_empty():
		_begin_file(_paths[selected[0]])


func _begin_file(p_path: String) -> void:
	var choice: SessionChoice = SessionChoice.new()
	choice.role = ProgramRoles.REPLAY
	choice.more = ["--file=" + p_path]
	begin_wanted.emit(choice)


func _choose_file() -> void:
	_files.popup_centered_ratio(0.8)
