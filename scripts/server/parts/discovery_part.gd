class_name DiscoveryPart
extends ServerPart
## Lets clients find this server: keeps what it tells them up to date. The thread of the port
## answers them.

## Time between two looks at what has changed, µs.
const _LOOK_USEC: int = 250000
const _HOST_NAME_FILE: String = "/proc/sys/kernel/hostname"
const _ANY_NAME: String = "Dismount"

var _announcement: ServerAnnouncement = ServerAnnouncement.new()
var _announced: PackedByteArray = []
var _looked_usec: int = 0
var _is_on: bool = false


func open(p_context: ServerContext) -> String:
	super(p_context)
	_is_on = context.options.is_on("discovery")
	_announcement.run = Crypto.new().generate_random_bytes(8).decode_s64(0)
	_announcement.program = ProjectSettings.get_setting("application/config/version")
	_announcement.name = name_of(context.options)
	return ""


func frame() -> void:
	var now: int = Time.get_ticks_usec()
	if not _is_on or now - _looked_usec < _LOOK_USEC:
		return
	_looked_usec = now
	var bytes: PackedByteArray = describe().encode()
	if bytes != _announced:
		_announced = bytes
		context.link.announcement = bytes


func report() -> Dictionary:
	return {"server_name": _announcement.name if _is_on else ""}


## What the server tells those who look for it.
func describe() -> ServerAnnouncement:
	var rules: ServerRules = context.link.rules
	_announcement.people = context.link.session_ids().size()
	_announcement.places = rules.max_clients
	_announcement.locked_roles = rules.locked_roles()
	_announcement.has_waiting_room = rules.waiting_room
	_announcement.seals = rules.seals
	_announcement.world = context.level.level_name
	return _announcement


## What a server with these options is called: as its options say, else like its machine.
static func name_of(p_options: Options) -> String:
	var name: String = p_options.text("server-name")
	if name == "" and FileAccess.file_exists(_HOST_NAME_FILE):
		name = FileAccess.open(_HOST_NAME_FILE, FileAccess.READ).get_line()
	name = ServerAnnouncement.shorten(name, ServerAnnouncement.MAX_NAME)
	return name if name != "" else _ANY_NAME
