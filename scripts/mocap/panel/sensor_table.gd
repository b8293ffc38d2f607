class_name SensorTable
extends Tree
## The sensors and their state, a row each; Enter on a row asks where the sensor is worn.

## A sensor is assigned to another mount; -1: it is not worn.
signal mount_chosen(p_sensor: String, p_mount: int)

## Titles of the columns.
const TITLES: PackedStringArray = [
	"Mount", "Sensor", "Where", "State", "Rate", "Loss", "Age", "Batt.", "Moves"
]
## Colour of what is wrong.
const WARN: Color = Color(1.0, 0.7, 0.25)

const _WIDTHS: PackedInt32Array = [126, 82, 104, 74, 52, 50, 48, 48, 54]
## A silence that is coloured, s.
const _OLD_S: float = 0.3
const _LOSSY: float = 0.02
const _LOW: float = 0.15
const _MOVES_DEG: float = 3.0
const _PLAIN: Color = Color(0.87, 0.89, 0.92)

var _rows: Dictionary[String, TreeItem] = {}
var _menu: PopupMenu = PopupMenu.new()
var _asked: String = ""
var _holds: bool = false


func _init() -> void:
	columns = TITLES.size()
	column_titles_visible = true
	hide_root = true
	select_mode = Tree.SELECT_ROW
	for column: int in TITLES.size():
		set_column_title(column, TITLES[column])
		set_column_title_alignment(column, HORIZONTAL_ALIGNMENT_LEFT)
		set_column_custom_minimum_width(column, _WIDTHS[column])
		set_column_expand(column, column < 3)
		set_column_clip_content(column, true)
	add_theme_constant_override("v_separation", 4)
	add_theme_constant_override("inner_item_margin_top", 0)
	add_theme_constant_override("inner_item_margin_bottom", 0)
	add_theme_font_size_override("font_size", 13)
	add_theme_font_size_override("title_button_font_size", 13)
	item_activated.connect(ask_mount)
	for mount: int in BodyMounts.COUNT:
		_menu.add_item(BodyMounts.title(mount), mount)
	_menu.add_item("not worn", BodyMounts.COUNT)
	_menu.id_pressed.connect(_choose)
	add_child(_menu)


## Shows sensors, with the mount of each (-1: none) and how far each moved of late, degrees; which
## is wrong while [param p_holds] still.
func show_sensors(
	p_sensors: Array[SensorInfo],
	p_mounts: PackedInt32Array,
	p_moves: PackedFloat32Array,
	p_holds: bool
) -> void:
	_holds = p_holds
	var order: Array = range(p_sensors.size())
	var ranks: PackedInt32Array = []
	for at: int in p_sensors.size():
		ranks.append((p_mounts[at] if p_mounts[at] >= 0 else 99) * 1000 + at)
	order.sort_custom(func(a: int, b: int) -> bool: return ranks[a] < ranks[b])
	var wanted: PackedStringArray = []
	for at: int in order:
		wanted.append(p_sensors[at].id)
	if wanted != PackedStringArray(_rows.keys()):
		_make_rows(wanted)
	for at: int in p_sensors.size():
		var moves: float = p_moves[at] if at < p_moves.size() else 0.0
		_show(_rows[p_sensors[at].id], p_sensors[at], p_mounts[at], moves)


## The sensor of the selected row, or an empty text.
func selected_sensor() -> String:
	var row: TreeItem = get_selected()
	return row.get_metadata(0) if row != null else ""


## Asks where the selected sensor is worn.
func ask_mount() -> void:
	_asked = selected_sensor()
	if _asked == "":
		return
	var row: Rect2 = get_item_area_rect(get_selected())
	_menu.reset_size()
	_menu.popup(Rect2i(get_screen_position() + row.position + Vector2(20.0, 0.0), Vector2i.ZERO))
	_menu.set_focused_item(0)


func _choose(p_mount: int) -> void:
	mount_chosen.emit(_asked, p_mount if p_mount < BodyMounts.COUNT else -1)
	grab_focus()


func _make_rows(p_ids: PackedStringArray) -> void:
	var selected: String = selected_sensor()
	clear()
	_rows.clear()
	var root: TreeItem = create_item()
	for id: String in p_ids:
		var row: TreeItem = create_item(root)
		row.set_metadata(0, id)
		_rows[id] = row
		if id == selected or selected == "":
			selected = id
			row.select(0)


func _show(p_row: TreeItem, p_info: SensorInfo, p_mount: int, p_moves: float) -> void:
	var is_on: bool = p_info.state == SensorInfo.State.MEASURING
	_cell(p_row, 0, BodyMounts.title(p_mount) if p_mount >= 0 else "not worn", p_mount < 0)
	_cell(p_row, 1, p_info.id, false)
	_cell(p_row, 2, p_info.where, false)
	_cell(p_row, 3, p_info.state_name(), not is_on)
	p_row.set_tooltip_text(3, p_info.trouble)
	_cell(p_row, 4, "%.0f Hz" % p_info.rate_hz if p_info.rate_hz > 0.0 else "-", false)
	_cell(p_row, 5, "%.1f %%" % (p_info.loss * 100.0), p_info.loss > _LOSSY)
	_cell(p_row, 6, age_text(p_info.age_s), p_info.age_s > _OLD_S)
	var battery: String = "%.0f %%" % (p_info.battery * 100.0) if p_info.battery >= 0.0 else "-"
	_cell(p_row, 7, battery, p_info.battery >= 0.0 and p_info.battery < _LOW)
	_cell(p_row, 8, "%.1f°" % p_moves, _holds and p_moves > _MOVES_DEG)


static func _cell(p_row: TreeItem, p_column: int, p_text: String, p_warns: bool) -> void:
	if p_row.get_text(p_column) != p_text:
		p_row.set_text(p_column, p_text)
	p_row.set_custom_color(p_column, WARN if p_warns else _PLAIN)


## An age for people, s.
static func age_text(p_age_s: float) -> String:
	if is_inf(p_age_s):
		return "-"
	if p_age_s < 1.0:
		return "%d ms" % roundi(p_age_s * 1000.0)
	return "%d s" % mini(roundi(p_age_s), 999)
