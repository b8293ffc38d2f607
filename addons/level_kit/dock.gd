@tool
extends VBoxContainer
## The dock: what can be placed, with search; New, Check, Bake and Try; what Check has found.

const Thumbnails: GDScript = preload("thumbnails.gd")
const DropArea: GDScript = preload("drop_area.gd")
const Trial: GDScript = preload("trial.gd")
const FaultList: GDScript = preload("fault_list.gd")
const TerrainBar: GDScript = preload("terrain_bar.gd")
const NEW_LEVEL_PATH: String = "res://addons/level_kit/new_level_dialog.gd"
const ICON_PX: int = 60
## Width that shows three things beside one another, pixels.
const WIDTH_PX: float = 270.0
const HELP: String = "Drag into the 3D view. Double-click to place several: R turns, Escape ends."

var _placer: RefCounted = null
var _items: Array = []
var _pictures: Dictionary[RefCounted, Texture2D] = {}
var _search: LineEdit = LineEdit.new()
var _grid: SpinBox = SpinBox.new()
var _list: ItemList = ItemList.new()
var _note: Label = Label.new()
var _progress: ProgressBar = ProgressBar.new()
var _faults: ItemList = FaultList.new()
var _thumbnails: Node = Thumbnails.new()
var _bar: Control = TerrainBar.new()
var _baker: LevelBaker = null
var _thread: Thread = null


func _init() -> void:
	name = "LevelKit"
	visibility_changed.connect(_fill_once)


func _ready() -> void:
	_fill_once()
	set_process(false)


func _exit_tree() -> void:
	if _thread != null:
		_thread.wait_to_finish()
		_thread = null


func _notification(p_what: int) -> void:
	if p_what == NOTIFICATION_DRAG_END and _placer != null:
		_placer.call("end_drag")


func _process(_delta: float) -> void:
	if _thread == null:
		return
	_progress.value = _baker.progress() * 100.0
	if not _thread.is_alive():
		_thread.wait_to_finish()
		_thread = null
		_end_bake()


## Tells it by what things are placed.
func configure(p_placer: RefCounted) -> void:
	_placer = p_placer
	_placer.connect("item_changed", _show_item)


## Tells it by what ground is shaped.
func add_brush(p_brush: RefCounted) -> void:
	_bar.call("configure", p_brush)


# Nothing is made before somebody sees the dock: the editor starts as fast as without it.
func _fill_once() -> void:
	if not is_visible_in_tree() or not _items.is_empty():
		return
	_items = KitCatalogue.items()
	_build()
	_show_found("")
	_thumbnails.connect("made", _show_picture)
	_thumbnails.call("ask", _items)


func _build() -> void:
	add_child(_thumbnails)
	custom_minimum_size.x = WIDTH_PX * EditorInterface.get_editor_scale()
	var top: HBoxContainer = HBoxContainer.new()
	_search.placeholder_text = "Search"
	_search.size_flags_horizontal = Control.SIZE_EXPAND_FILL
	_search.clear_button_enabled = true
	_search.text_changed.connect(_show_found)
	top.add_child(_search)
	_grid.max_value = 10.0
	_grid.step = 0.05
	_grid.suffix = "m"
	_grid.value = _placer.get("grid_m")
	_grid.tooltip_text = "Grid for what is placed; 0 for none. The editor's own snap goes before it."
	_grid.value_changed.connect(func(value: float) -> void: _placer.set("grid_m", value))
	top.add_child(_grid)
	add_child(top)
	_list.icon_mode = ItemList.ICON_MODE_TOP
	_list.max_columns = 0
	_list.same_column_width = true
	_list.fixed_column_width = ICON_PX + 12
	_list.fixed_icon_size = Vector2i(ICON_PX, ICON_PX)
	_list.size_flags_vertical = Control.SIZE_EXPAND_FILL
	_list.custom_minimum_size.y = 120.0
	_list.tooltip_text = HELP
	# Else the list takes the editor's own keys, Ctrl+S too.
	_list.allow_search = false
	_list.item_activated.connect(_on_activated)
	_list.set_drag_forwarding(_get_dragged, Callable(), Callable())
	add_child(_list)
	add_child(_bar)
	add_child(_make_buttons())
	_note.autowrap_mode = TextServer.AUTOWRAP_WORD_SMART
	_note.text = HELP
	add_child(_note)
	_progress.hide()
	add_child(_progress)
	_faults.hide()
	add_child(_faults)


func _make_buttons() -> Control:
	var row: HFlowContainer = HFlowContainer.new()
	var verbs: Dictionary[String, Callable] = {
		"New level": _open_new, "Check level": _check, "Bake level": _bake, "Try level": _try
	}
	for title: String in verbs:
		var button: Button = Button.new()
		button.name = title.to_pascal_case()
		button.text = title
		button.pressed.connect(verbs[title])
		row.add_child(button)
	return row


func _show_found(p_search: String) -> void:
	_list.clear()
	for item: RefCounted in _items:
		if item.call("fits", p_search):
			var icon: Texture2D = _pictures.get(item, _plain_icon())
			_list.set_item_metadata(_list.add_item(item.get("title"), icon), item)


func _plain_icon() -> Texture2D:
	return get_theme_icon(&"Node3D", &"EditorIcons")


func _show_picture(p_item: RefCounted, p_picture: Texture2D) -> void:
	_pictures[p_item] = p_picture
	for index: int in _list.item_count:
		if _list.get_item_metadata(index) == p_item:
			_list.set_item_icon(index, p_picture)


func _get_dragged(p_at: Vector2) -> Variant:
	var index: int = _list.get_item_at_position(p_at, true)
	if index < 0:
		return null
	var title: Label = Label.new()
	title.text = _list.get_item_text(index)
	_list.set_drag_preview(title)
	_placer.call("stop")
	_placer.call("begin_drag")
	return {DropArea.KEY: _list.get_item_metadata(index)}


func _on_activated(p_index: int) -> void:
	EditorInterface.set_main_screen_editor("3D")
	_placer.call("start", _list.get_item_metadata(p_index))


func _show_item(p_item: RefCounted) -> void:
	if p_item == null:
		_note.text = HELP
	else:
		var text: String = "Each click places one more %s. R turns it, Escape ends."
		_note.text = text % str(p_item.get("title")).to_lower()


## The level that is edited, or null, with a word about it.
func _find_level() -> Level:
	var level: Level = EditorInterface.get_edited_scene_root() as Level
	if level == null:
		_note.text = "Open a level first: a scene whose root is a Level. Or press New level."
	return level


func _open_new() -> void:
	var dialog: ConfirmationDialog = (load(NEW_LEVEL_PATH) as GDScript).new()
	add_child(dialog)
	dialog.popup_centered()


func _check() -> void:
	var level: Level = _find_level()
	if level == null:
		return
	var check: LevelCheck = LevelCheck.new(level)
	check.run()
	_faults.call("show_faults", level, check.faults)
	var hints: int = check.faults.size() - check.count_faults()
	_note.text = "%d faults, %d hints." % [check.count_faults(), hints]
	if not check.faults.is_empty():
		_note.text += " Click one to see it."


func _bake() -> void:
	var level: Level = _find_level()
	if level == null or _thread != null:
		return
	if level.scene_file_path == "":
		_note.text = "Save the level first: what is baked lies beside it."
		return
	_baker = LevelBaker.new()
	_baker.prepare(level)
	_baker.set_meta(&"path", Level.bake_path_of(level.scene_file_path))
	_progress.value = 0.0
	_progress.show()
	_note.text = "Working out light and what is seen from where. You can go on, but do not save yet."
	_thread = Thread.new()
	_thread.start(_baker.run)
	set_process(true)


func _end_bake() -> void:
	set_process(false)
	_progress.hide()
	var path: String = _baker.get_meta(&"path")
	var error: Error = _baker.bake.save_file(path)
	_note.text = "%s: %s" % [path.get_file(), _baker.bake.describe()]
	if error != OK:
		_note.text = "%s: %s" % [path, error_string(error)]
	_baker = null


func _try() -> void:
	var level: Level = _find_level()
	if level == null:
		return
	if level.scene_file_path != "":
		# Without the picture of it, for which the whole editor is drawn several times.
		EditorInterface.save_scene_as(level.scene_file_path, false)
	_note.text = Trial.start(level.scene_file_path)
