class_name SensorTable
extends UiList
## The sensors and their state, a row each; Enter on a row asks where the sensor is worn.

## A sensor is assigned to another mount; -1: it is not worn.
signal mount_chosen(p_sensor: String, p_mount: int)

## Titles of the columns.
const TITLES: PackedStringArray = [
	"Worn at", "Sensor", "Where", "State", "Quality", "Drift", "Field", "Moves"
]
## Colours of what is wrong, and of what is good.
const WARN: Color = UiStyle.WARN
const BAD: Color = UiStyle.BAD
const GOOD: Color = UiStyle.GOOD

const _WIDTHS: PackedInt32Array = [122, 84, 104, 100, 78, 78, 76, 62]
## A silence that is told, s.
const _OLD_S: float = 0.3
const _LOSSY: float = 0.02
const _LOW: float = 0.15
const _MOVES_DEG: float = 3.0
## Drift that is corrected and yet worth a look, degrees a minute.
const _DRIFTS_DEG_MIN: float = 3.0
const _PLAIN: Color = UiStyle.TEXT
const _QUALITIES: Dictionary[String, Color] = {"good": GOOD, "fair": WARN}
const _FIELDS: Dictionary[MagneticWatch.Verdict, Color] = {
	MagneticWatch.Verdict.UNKNOWN: _PLAIN,
	MagneticWatch.Verdict.GOOD: GOOD,
	MagneticWatch.Verdict.DISTURBED: BAD,
}

var _rows: Dictionary[String, TreeItem] = {}
var _menu: PopupMenu = PopupMenu.new()
var _asked: String = ""
var _mounts: Dictionary[String, int] = {}


func _init() -> void:
	set_titles(TITLES, _WIDTHS, 2)
	add_theme_constant_override("v_separation", 4)
	add_theme_constant_override("inner_item_margin_top", 0)
	add_theme_constant_override("inner_item_margin_bottom", 0)
	item_activated.connect(ask_mount)
	for mount: int in BodyMounts.COUNT:
		_menu.add_radio_check_item(BodyMounts.title(mount), mount)
	_menu.add_radio_check_item("not worn", BodyMounts.COUNT)
	_menu.id_pressed.connect(_choose)
	add_child(_menu)


## Shows the sensors of a suit, by where they are worn.
func show_suit(p_suit: SuitSource) -> void:
	var sensors: Array[SensorInfo] = p_suit.feed.list_sensors()
	var mounts: PackedInt32Array = p_suit.get_profile().map.of_sensors(sensors)
	var order: Array = range(sensors.size())
	var ranks: PackedInt32Array = []
	for at: int in sensors.size():
		ranks.append((mounts[at] if mounts[at] >= 0 else 99) * 1000 + at)
	order.sort_custom(func(a: int, b: int) -> bool: return ranks[a] < ranks[b])
	var wanted: PackedStringArray = []
	for at: int in order:
		wanted.append(sensors[at].id)
	if wanted != PackedStringArray(_rows.keys()):
		_make_rows(wanted)
	for at: int in sensors.size():
		var row: TreeItem = _rows[sensors[at].id]
		_mounts[sensors[at].id] = mounts[at]
		_show_sensor(row, sensors[at], mounts[at])
		_show_health(row, p_suit, mounts[at])
		_show_movement(row, p_suit.process, at)


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
	# Where it is now.
	var mount: int = _mounts.get(_asked, -1)
	for item: int in _menu.item_count:
		_menu.set_item_checked(item, item == (mount if mount >= 0 else BodyMounts.COUNT))
	_menu.set_focused_item(mount if mount >= 0 else BodyMounts.COUNT)


func _choose(p_mount: int) -> void:
	mount_chosen.emit(_asked, p_mount if p_mount < BodyMounts.COUNT else -1)
	grab_focus()


func _make_rows(p_ids: PackedStringArray) -> void:
	var selected: String = selected_sensor()
	clear_rows()
	_rows.clear()
	for id: String in p_ids:
		var row: TreeItem = add_row([])
		row.set_metadata(0, id)
		_rows[id] = row
		if id == selected or selected == "":
			selected = id
			row.select(0)


func _show_sensor(p_row: TreeItem, p_info: SensorInfo, p_mount: int) -> void:
	var title: String = BodyMounts.title(p_mount) if p_mount >= 0 else "not worn"
	_cell(p_row, 0, title, _PLAIN if p_mount >= 0 else WARN)
	_cell(p_row, 1, p_info.id, _PLAIN)
	# Of which kind the device is, its own list says.
	var ends: PackedStringArray = p_info.where.split(" / ")
	ends[0] = ends[0].get_slice(" ", ends[0].get_slice_count(" ") - 1)
	_cell(p_row, 2, " / ".join(ends))
	p_row.set_tooltip_text(2, p_info.where)
	_cell(p_row, 3, state_text(p_info), _PLAIN if _is_well(p_info) else WARN)
	p_row.set_tooltip_text(3, p_info.trouble)


## What a sensor does, for people: that something is wrong, or how often it measures.
static func state_text(p_info: SensorInfo) -> String:
	if p_info.state != SensorInfo.State.MEASURING or p_info.age_s > _OLD_S:
		var since: String = " %s" % age_text(p_info.age_s) if is_finite(p_info.age_s) else ""
		return p_info.state_name() + since
	if p_info.loss > _LOSSY:
		return "loses %.0f %%" % (p_info.loss * 100.0)
	if p_info.battery >= 0.0 and p_info.battery < _LOW:
		return "battery %.0f %%" % (p_info.battery * 100.0)
	return "%.0f Hz" % p_info.rate_hz if p_info.rate_hz > 0.0 else p_info.state_name()


static func _is_well(p_info: SensorInfo) -> bool:
	var is_fresh: bool = p_info.state == SensorInfo.State.MEASURING and p_info.age_s <= _OLD_S
	var is_full: bool = p_info.battery < 0.0 or p_info.battery >= _LOW
	return is_fresh and is_full and p_info.loss <= _LOSSY


func _show_health(p_row: TreeItem, p_suit: SuitSource, p_mount: int) -> void:
	var result: CalibrationResult = p_suit.process.result
	if result == null or result.calibration == null:
		result = p_suit.quality
	var place: CalibrationResult.PlaceQuality = null
	if result != null and p_mount >= 0:
		place = result.find(p_mount)
	if place == null or place.sensor != p_row.get_metadata(0):
		_cell(p_row, 4, "–")
	else:
		var grade: String = place.grade()
		var is_graded: bool = ["good", "fair", "poor"].has(grade)
		var text: String = "%s %.0f°" % [grade, place.error_deg] if is_graded else grade
		_cell(p_row, 4, text, _QUALITIES.get(grade, BAD))
	if p_mount < 0 or not p_suit.is_calibrated():
		_cell(p_row, 5, "–")
		_cell(p_row, 6, "–")
		return
	var drift: float = absf(p_suit.headings.rate_deg_min(p_mount))
	var is_steady: bool = drift < HeadingKeeper.STEADY_DEG_MIN
	var color: Color = GOOD if is_steady else WARN if drift > _DRIFTS_DEG_MIN else _PLAIN
	_cell(p_row, 5, "steady" if is_steady else "%.1f°/min" % drift, color)
	p_row.set_tooltip_text(5, p_suit.headings.describe(p_mount))
	var field: MagneticWatch.Verdict = p_suit.magnetics.judge(p_mount)
	_cell(p_row, 6, p_suit.magnetics.word(p_mount), _FIELDS[field])
	p_row.set_tooltip_text(6, p_suit.magnetics.describe(p_mount))


func _show_movement(p_row: TreeItem, p_process: CalibrationProcess, p_sensor: int) -> void:
	var moves: float = 0.0
	if p_sensor < p_process.live_deg.size():
		moves = p_process.live_deg[p_sensor]
	var is_too_much: bool = p_process.phase == CalibrationProcess.Phase.HOLD and moves > _MOVES_DEG
	_cell(p_row, 7, "%.1f°" % moves, WARN if is_too_much else _PLAIN)


static func _cell(p_row: TreeItem, p_column: int, p_text: String, p_color: Color = _PLAIN) -> void:
	if p_row.get_text(p_column) != p_text:
		p_row.set_text(p_column, p_text)
	p_row.set_custom_color(p_column, p_color)


## An age for people, s.
static func age_text(p_age_s: float) -> String:
	if is_inf(p_age_s):
		return "-"
	if p_age_s < 1.0:
		return "%d ms" % roundi(p_age_s * 1000.0)
	return "%d s" % mini(roundi(p_age_s), 999)
