class_name MirrorSheet
extends PanelSheet
## The wearer in a mirror, beside what there is to know before joining: devices, what is wrong, size
## and calibration, the avatar. Who and what it is comes as texts; the body is put into the
## [MirrorView] by whoever has one.

## Another avatar is wanted: a place in the list of [method show_avatars].
signal avatar_chosen(p_at: int)
## Another of the people is to be seen: a place in the list of [method show_people].
signal person_chosen(p_at: int)
## The sheet of sources is wanted.
signal sources_wanted
## The session is to begin.
signal join_wanted
## The session that is being joined is not wanted after all.
signal stop_wanted

## Below this width, px, the words stand below the mirror.
const BESIDE_PX: float = 640.0
## Width of the words beside the mirror, as a share, and its limits, px.
const _WORDS: float = 0.42
const _WORDS_PX: Vector2 = Vector2(300.0, 640.0)

## The mirror.
@export var mirror: MirrorView

@export var _middle: BoxContainer
@export var _words: Container
@export var _people: OptionButton
@export var _close: Button
@export var _sides: Container
@export var _trouble: Label
@export var _wearer: Label
@export var _avatars: OptionButton
@export var _devices: DeviceList
@export var _sources: Button
@export var _session: Label
@export var _join: Button

var _is_joining: bool = false


func _ready() -> void:
	_close.text = "Devices [Esc]"
	_close.pressed.connect(close_wanted.emit)
	for each: String in MirrorView.Direction.keys():
		var button: Button = Button.new()
		button.text = each.capitalize()
		button.name = button.text
		button.size_flags_horizontal = Control.SIZE_EXPAND_FILL
		button.pressed.connect(mirror.show_from.bind(MirrorView.Direction[each]))
		_sides.add_child(button)
	_people.item_selected.connect(person_chosen.emit)
	_avatars.item_selected.connect(avatar_chosen.emit)
	_sources.text = InputKeys.label("Sources", &"toggle_source_sheet")
	_sources.pressed.connect(sources_wanted.emit)
	_join.pressed.connect(_press_join)
	_devices.set_titles(DeviceList.TITLES, [116, 76, 60], 2)
	show_people([], 0)
	show_wearer("")
	show_trouble("")
	offer_session("")
	resized.connect(_fit)
	_fit()


func focus_first() -> void:
	if _join.visible:
		_join.grab_focus()
	else:
		_close.grab_focus()


## Lists who can be seen, and which of them is; the list is there where there are several.
func show_people(p_names: PackedStringArray, p_at: int) -> void:
	_fill(_people, p_names, p_at)
	_people.visible = p_names.size() > 1


## Lists the avatars, and which of them is worn.
func show_avatars(p_names: PackedStringArray, p_at: int) -> void:
	_fill(_avatars, p_names, p_at)


## Says who is seen, how tall, and whether calibrated; nothing if empty.
func show_wearer(p_text: String) -> void:
	_wearer.text = p_text
	_wearer.visible = p_text != ""


## Says what is wrong and what to do; nothing if empty.
func show_trouble(p_text: String) -> void:
	_trouble.text = p_text
	_trouble.visible = p_text != ""


## Shows devices and sources: see [method DeviceList.show_devices].
func show_devices(p_devices: Array[Dictionary]) -> void:
	_devices.show_devices(p_devices)


## Offers to join a session at an address; empty: there is nothing to join.
func offer_session(p_where: String) -> void:
	_join.visible = p_where != ""
	_session.visible = p_where != ""
	_join.tooltip_text = p_where
	show_session("", false)


## Says how far joining the session is, and whether it goes on.
func show_session(p_text: String, p_is_joining: bool) -> void:
	var idle: String = "Nobody else sees you yet. The session is at %s." % _join.tooltip_text
	_session.text = p_text if p_text != "" else idle
	_session.theme_type_variation = &"" if p_text == "" or p_is_joining else UiStyle.WARNING
	_is_joining = p_is_joining
	_join.text = "Stop joining" if p_is_joining else "Join"


func _press_join() -> void:
	if _is_joining:
		stop_wanted.emit()
	else:
		join_wanted.emit()


func _fit() -> void:
	_middle.vertical = size.x < BESIDE_PX
	var wide: float = clampf(size.x * _WORDS, _WORDS_PX.x, _WORDS_PX.y)
	_words.custom_minimum_size.x = 0.0 if _middle.vertical else wide


static func _fill(p_list: OptionButton, p_names: PackedStringArray, p_at: int) -> void:
	var present: PackedStringArray = []
	for at: int in p_list.item_count:
		present.append(p_list.get_item_text(at))
	if present != p_names and not p_list.get_popup().visible:
		p_list.clear()
		for name: String in p_names:
			p_list.add_item(name)
	if p_list.item_count == p_names.size():
		p_list.selected = clampi(p_at, -1, p_names.size() - 1)
