class_name SourceSheet
extends PanelSheet
## What motion is sent to this machine, to be taken with Enter; and which source gives which limbs
## of the first one's person. Sources come as dictionaries and numbers: what they are is not known
## here.

## It is to be listened on the usual ports, or no more.
signal listening_wanted(p_is_wanted: bool)
## A source is to be opened: as [code]--source[/code] names it.
signal source_wanted(p_source: String)
## A group of limbs is to come from the source of a number, counted from 1.
signal group_chosen(p_group: int, p_number: int)

## Keys of what was heard that are shown.
const KEYS: PackedStringArray = ["name", "state", "detail"]
const _TITLES: PackedStringArray = ["What", "State", "Details"]
const _WIDTHS: PackedInt32Array = [250, 80, 330]
const _NONE: String = "Nothing is heard yet. Let the suit's program send to this machine's address."

@export var _heard: UiList
@export var _grid: GridContainer
@export var _fault: Label
@export var _close: Button

var _shown: Array[Dictionary] = []
var _lists: Array[OptionButton] = []


func _ready() -> void:
	_heard.set_titles(_TITLES, _WIDTHS, 2)
	_heard.item_activated.connect(_take)
	_close.pressed.connect(close_wanted.emit)
	visibility_changed.connect(func() -> void: listening_wanted.emit(is_visible_in_tree()))
	show_heard([])


## Shows who is heard: dictionaries with [constant KEYS], and "source" where it can be taken.
func show_heard(p_rows: Array[Dictionary]) -> void:
	if p_rows == _shown and _heard.get_root() != null:
		return
	_shown = p_rows.duplicate(true)
	var selected: String = _selected()
	_heard.clear_rows()
	if p_rows.is_empty():
		_heard.add_row(["", "", _NONE], 2)
	for row: Dictionary in p_rows:
		var item: TreeItem = _heard.add_row([])
		for column: int in KEYS.size():
			item.set_text(column, str(row.get(KEYS[column], "")))
			item.set_autowrap_mode(column, TextServer.AUTOWRAP_WORD_SMART)
		item.set_metadata(0, str(row.get("source", "")))
		if item.get_metadata(0) == selected and selected != "":
			item.select(0)


## Shows which of the sources (dictionaries with "number", "name" and "person") gives which group.
func show_groups(
	p_groups: PackedStringArray, p_choices: PackedInt32Array, p_sources: Array[Dictionary]
) -> void:
	if _lists.size() != p_groups.size():
		_make_lists(p_groups)
	for group: int in p_groups.size():
		var list: OptionButton = _lists[group]
		if list.get_popup().visible:
			continue
		list.clear()
		for source: Dictionary in p_sources:
			var who: String = str(source.get("person", ""))
			var parts: Array = [source.get("number", 0), source.get("name", "")]
			list.add_item("%d: %s" % parts + (", " + who if who != "" else ""))
		list.selected = clampi(p_choices[group] - 1, -1, p_sources.size() - 1)
		list.disabled = p_sources.size() < 2


## Shows what was wrong with the last thing that was asked for.
func show_fault(p_fault: String) -> void:
	_fault.text = p_fault


## Gives the list the keyboard.
func focus_first() -> void:
	_heard.grab_focus()


func _make_lists(p_groups: PackedStringArray) -> void:
	for group: int in p_groups.size():
		var label: Label = Label.new()
		label.text = p_groups[group]
		_grid.add_child(label)
		var list: OptionButton = OptionButton.new()
		list.custom_minimum_size.x = 240.0
		list.clip_text = true
		list.item_selected.connect(func(at: int) -> void: group_chosen.emit(group, at + 1))
		_grid.add_child(list)
		_lists.append(list)


func _selected() -> String:
	var item: TreeItem = _heard.get_selected()
	return str(item.get_metadata(0)) if item != null else ""


func _take() -> void:
	if _selected() != "" and _selected() != "<null>":
		source_wanted.emit(_selected())
