extends TestCase
## The sheet of sources shows what it is given and says what is wanted.

var _panel: DevicePanel = null
var _sheet: SourceSheet = null


func before_each() -> void:
	get_window().size = Vector2i(1280, 720)
	_panel = (load("res://scenes/mocap/panel/device_panel.tscn") as PackedScene).instantiate()
	_panel.folder = "user://test-sources-%d" % OS.get_process_id()
	add_child(_panel)
	_sheet = _panel.sources()
	await process_frames(1)


func after_each() -> void:
	_panel.queue_free()
	await process_frames(2)


func test_listening_begins_and_ends_with_the_sheet() -> void:
	var wanted: Array[bool] = []
	_sheet.listening_wanted.connect(wanted.append)
	for shows: bool in [true, false]:
		var event: InputEventAction = InputEventAction.new()
		event.action = &"toggle_source_sheet"
		event.pressed = true
		Input.parse_input_event(event)
		Input.flush_buffered_events()
		await process_frames(2)
		equal(_sheet.visible, shows)
	equal(wanted, [true, false] as Array[bool])


func test_rows_and_groups_fit_and_are_chosen() -> void:
	_sheet.visible = true
	var rows: Array[Dictionary] = []
	for number: int in 6:
		var name: String = "A program with quite a long name (UDP port 3953%d)" % number
		var detail: String = "from 192.168.100.10%d, 240 datagrams/s, not understood" % number
		rows.append({"source": "vmc:%d" % number, "name": name, "state": "heard", "detail": detail})
	_sheet.show_heard(rows)
	var sources: Array[Dictionary] = [
		{"number": 1, "name": "xbus", "person": "Anna"}, {"number": 2, "name": "vmc", "person": ""}
	]
	_sheet.show_groups(LimbFusion.NAMES, [1, 1, 2, 1, 1, 1, 1, 2], sources)
	_sheet.show_fault("UDP port 39539 is in use: end the other program, or name another port")
	await process_frames(2)
	var window: Rect2 = Rect2(Vector2.ZERO, Vector2(1280, 720))
	is_true(window.encloses(_sheet.get_global_rect()), str(_sheet.get_global_rect()))
	var lists: Array[Node] = _sheet.find_children("*", "OptionButton", true, false)
	equal(lists.size(), LimbFusion.NAMES.size())
	equal((lists[2] as OptionButton).text, "2: vmc")
	equal((lists[0] as OptionButton).text, "1: xbus, Anna")
	var chosen: Array[Vector2i] = []
	_sheet.group_chosen.connect(
		func(group: int, number: int) -> void: chosen.append(Vector2i(group, number))
	)
	(lists[3] as OptionButton).item_selected.emit(1)
	equal(chosen, [Vector2i(3, 2)] as Array[Vector2i])
