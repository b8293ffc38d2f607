class_name HostScreen
extends ShellScreen
## Begins a session of the user's own: which world, how it is there, who may join, and as what the
## user takes part. The server runs beside this program as a process of its own.

## The user wants this server, and to take part in its session.
signal host_wanted(p_server: HostedServer, p_choice: SessionChoice)

## Roles that a host can take, and what they are for the host.
const _ROLES: Dictionary[String, String] = {
	"trainee": "With a body of my own", "instructor": "As the instructor", "observer": "Watching"
}
const _WORLDS_OWN: String = "As the world has it"

## UDP port of the server, where it is free.
var wanted_port: int = Protocol.DEFAULT_PORT:
	set(p_port):
		wanted_port = p_port
		_show_addresses()

var _world: WorldPicker = WorldPicker.new()
var _role: OptionButton = OptionButton.new()
var _weather: OptionButton = OptionButton.new()
var _time: OptionButton = OptionButton.new()
var _name: LineEdit = LineEdit.new()
var _password: LineEdit = LineEdit.new()
var _network: CheckButton = CheckButton.new()
var _records: CheckButton = CheckButton.new()
var _stays: CheckButton = CheckButton.new()
var _addresses: Label = null
var _begin: Button = null


func _init() -> void:
	super("Host a session")
	content.add_child(_world)
	_fill_lists()
	_name.max_length = Protocol.MAX_NAME
	_name.placeholder_text = "as others see you"
	_password.secret = true
	_password.placeholder_text = "none: everybody may join"
	for row: Array in [
		["I take part", _role],
		["Your name", _name],
		["Time", _time],
		["Weather", _weather],
		["Password", _password],
	]:
		content.add_child(UiRow.new(row[0], row[1]))
	_network.text = "Others on this network can join"
	_network.button_pressed = true
	_network.toggled.connect(_show_addresses.unbind(1))
	_records.text = "Record the session"
	_stays.text = "The server goes on when I leave"
	for button: CheckButton in [_network, _records, _stays]:
		button.name = button.text.to_pascal_case()
		button.autowrap_mode = TextServer.AUTOWRAP_WORD_SMART
		content.add_child(button)
	_addresses = add_text("", UiStyle.HINT)
	add_answer("Back", closed.emit)
	_begin = add_answer("Begin", _on_begin)
	_begin.theme_type_variation = UiStyle.PRIMARY
	_show_addresses()


func _notification(p_what: int) -> void:
	if p_what == NOTIFICATION_TRANSLATION_CHANGED and _addresses != null:
		_show_addresses()


func focus_first() -> void:
	_begin.grab_focus()


func _fill_lists() -> void:
	for role: String in _ROLES:
		_role.add_item(_ROLES[role])
		_role.set_item_metadata(-1, role)
	_weather.add_item(_WORLDS_OWN)
	for weather: String in WorldConditions.WEATHERS:
		_weather.add_item(weather.capitalize())
		_weather.set_item_metadata(-1, weather)
	_time.add_item(_WORLDS_OWN)
	for time: String in WorldConditions.TIMES:
		_time.add_item(time.capitalize())
		_time.set_item_metadata(-1, time)


func _on_begin() -> void:
	var server: HostedServer = HostedServer.new()
	server.wanted_port = wanted_port
	server.world = _world.world
	server.password = _password.text
	server.is_on_network = _network.button_pressed
	server.stays = _stays.button_pressed
	server.more = _more()
	var choice: SessionChoice = SessionChoice.new()
	choice.role = _role.get_selected_metadata()
	choice.host = "127.0.0.1"
	choice.name = _name.text.strip_edges()
	choice.password = server.password
	host_wanted.emit(server, choice)


## The server's options for time, weather and recording.
func _more() -> PackedStringArray:
	var more: PackedStringArray = []
	if _time.get_selected_metadata() != null:
		more.append("--time=" + str(_time.get_selected_metadata()))
	if _weather.get_selected_metadata() != null:
		more.append("--weather=" + str(_weather.get_selected_metadata()))
	if _records.button_pressed:
		more.append("--record=" + SessionFiles.new_recording(_world.world))
	return more


func _show_addresses() -> void:
	var found: PackedStringArray = HostedServer.addresses()
	var port: int = HostedServer.find_port(wanted_port)
	if not _network.button_pressed:
		_addresses.text = tr("Only this machine can join.")
	elif found.is_empty():
		_addresses.text = tr("This machine is on no network: nobody else can join.")
	else:
		_addresses.text = (
			tr("Others find it in their list, or type %s, port %d.") % [found[0], port]
		)
