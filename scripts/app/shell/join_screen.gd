class_name JoinScreen
extends ShellScreen
## Takes part in a session: the servers of this network, which appear by themselves, favourites, any
## address; under which name, as what, and by which password.

const _ROLES: Dictionary[String, String] = {
	"trainee": "With a body of my own", "observer": "Watching", "instructor": "As the instructor"
}
const _COLUMNS: PackedStringArray = ["Server", "World", "People", "Delay", ""]
const _WIDTHS: PackedInt32Array = [180, 110, 80, 80, 110]
## Height of the list as a share of the window's, so that the form below is seen, too.
const _LIST_SHARE: float = 0.28

## Looks for servers.
var finder: ServerFinder = null

var _book: ServerBook = null
var _list: UiList = UiList.new()
var _address: LineEdit = LineEdit.new()
var _name: LineEdit = LineEdit.new()
var _role: OptionButton = OptionButton.new()
var _password: LineEdit = LineEdit.new()
var _fault: Label = null
var _join: Button = null
var _favourite: Button = null


## Servers are found by a finder, which begins when the screen is shown; by default what is
## remembered of them is the user's own.
func _init(p_finder: ServerFinder, p_book: ServerBook = null) -> void:
	super("Join a session")
	finder = p_finder
	_book = p_book if p_book != null else ServerBook.new()
	_list.set_titles(_COLUMNS, _WIDTHS, 0)
	_list.auto_translate_mode = Node.AUTO_TRANSLATE_MODE_DISABLED
	_list.item_selected.connect(_on_selected)
	_list.item_activated.connect(_on_join)
	content.add_child(_list)
	add_text("Servers of this network appear by themselves.", UiStyle.HINT)
	_address.placeholder_text = "name or address, with :port if it is not 7777"
	_address.text_submitted.connect(_on_join.unbind(1))
	_address.text_changed.connect(_show_favourite.unbind(1))
	_name.max_length = Protocol.MAX_NAME
	_name.placeholder_text = "as others see you"
	_password.secret = true
	_password.text_submitted.connect(_on_join.unbind(1))
	for role: String in _ROLES:
		_role.add_item(_ROLES[role])
		_role.set_item_metadata(-1, role)
	for row: Array in [
		["Address", _address], ["Your name", _name], ["I take part", _role], ["Password", _password]
	]:
		content.add_child(UiRow.new(row[0], row[1]))
	_fault = add_text("", UiStyle.WARNING)
	add_answer("Back", closed.emit)
	_favourite = add_answer("Add to favourites", _on_favourite)
	_join = add_answer("Join", _on_join)
	_join.theme_type_variation = UiStyle.PRIMARY
	_address.text = _book.last_address
	_name.text = _book.last_name


func _ready() -> void:
	super()
	finder.changed.connect(_show_servers)
	finder.begin()
	for address: String in _book.favourites:
		finder.want(ServerAddress.parse(address))
	_show_servers()
	_show_favourite()


func _process(_delta: float) -> void:
	finder.poll()
	_list.custom_minimum_size.y = _LIST_SHARE * get_viewport_rect().size.y


func _exit_tree() -> void:
	finder.close()


func focus_first() -> void:
	if _address.text == "":
		_address.grab_focus()
	else:
		_join.grab_focus()


## Takes over what a session was to be begun with, such as one that was refused.
func take(p_choice: SessionChoice) -> void:
	choose_role(p_choice.role)
	_name.text = p_choice.name
	var address: ServerAddress = ServerAddress.new()
	address.host = p_choice.host
	address.port = p_choice.port
	_address.text = address.describe()
	_show_favourite()


## Chooses as what the user takes part, by the role's name.
func choose_role(p_role: String) -> void:
	for at: int in _role.item_count:
		if _role.get_item_metadata(at) == p_role:
			_role.select(at)


func _show_servers() -> void:
	var chosen: String = _selected()
	_list.clear_rows()
	for server: FoundServer in finder.servers():
		var row: TreeItem = _list.add_row(_cells(server))
		row.set_metadata(0, server.describe())
		if server.describe() == chosen:
			row.select(0)


func _cells(p_server: FoundServer) -> PackedStringArray:
	var star: String = "* " if _book.has(p_server.describe()) else ""
	if not p_server.answers():
		return [star + p_server.title(), "", "", "", tr("no answer")]
	var said: ServerAnnouncement = p_server.announcement
	var note: String = ""
	if not p_server.is_same_version():
		note = tr("other version")
	elif p_server.needs_password(Roles.Role.TRAINEE):
		note = tr("password")
	elif said.has_waiting_room:
		note = tr("waiting room")
	return [
		star + p_server.title(),
		said.world,
		"%d / %d" % [said.people, said.places],
		"%d ms" % roundi(1000.0 * p_server.delay_s),
		note,
	]


func _selected() -> String:
	var row: TreeItem = _list.get_selected()
	return str(row.get_metadata(0)) if row != null else ""


func _on_selected() -> void:
	_address.text = _selected()
	_show_favourite()


func _show_favourite() -> void:
	var is_there: bool = _book.has(_address.text.strip_edges())
	_favourite.text = "Remove from favourites" if is_there else "Add to favourites"


func _on_favourite() -> void:
	var address: ServerAddress = ServerAddress.parse(_address.text)
	_fault.text = address.error
	if address.error != "":
		return
	_book.toggle(address.describe())
	if _book.has(address.describe()):
		finder.want(address)
	_show_favourite()
	_show_servers()


func _on_join() -> void:
	var address: ServerAddress = ServerAddress.parse(_address.text)
	_fault.text = address.error
	if address.error != "":
		_address.grab_focus()
		return
	var choice: SessionChoice = SessionChoice.new()
	choice.role = _role.get_selected_metadata()
	choice.host = address.host
	choice.port = address.port
	choice.name = _name.text.strip_edges()
	choice.password = _password.text
	_book.remember(address.describe(), choice.name)
	begin_wanted.emit(choice)
