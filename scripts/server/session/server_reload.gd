class_name ServerReload
extends RefCounted
## What a server takes over from its options while it runs: after SIGHUP it reads the configuration
## file and the list of bans again and opens its log file anew.

## The options that take effect at once.
const CHANGEABLE: PackedStringArray = [
	"password",
	"instructor-password",
	"max-clients",
	"max-per-address",
	"max-people",
	"bandwidth",
	"waiting-room",
	"ban-file",
	"log-file",
	"log-level",
]

var _options: Options = null
var _rules: ServerRules = null
# Number of clients that have room in the open port.
var _room: int = TransportLimits.MIN_CLIENTS


func _init(p_options: Options, p_rules: ServerRules) -> void:
	_options = p_options
	_rules = p_rules
	_room = maxi(_room, p_options.number("max-clients"))


## Reads everything again. What cannot be read changes nothing and is logged. Returns the options
## that hold from now on.
func reload() -> Options:
	# First: so that what follows stands in the new file.
	var fault: String = Log.open(_options.text("log-level"), _options.file("log-file"))
	if fault != "":
		Log.warning("server", fault)
	var read: Options = _options.reread()
	if read.error != "":
		Log.warning("server", "SIGHUP: nothing is changed: " + read.error)
		return _options
	var bans: BanList = BanList.open(read.file("ban-file"))
	if bans.error != "":
		Log.warning("server", "SIGHUP: nothing is changed: " + bans.error)
		return _options
	fault = Log.open(read.text("log-level"), read.file("log-file"))
	if fault != "":
		Log.warning("server", fault)
	_describe(read)
	_options = read
	apply(read, _rules)
	if _rules.max_clients > _room:
		_rules.max_clients = _room
		Log.warning("server", "SIGHUP: more than %d clients need a new start" % _room)
	_rules.bans = bans
	return read


## Puts what may change into the rules; the list of bans is the caller's.
static func apply(p_options: Options, r_rules: ServerRules) -> void:
	r_rules.max_clients = p_options.number("max-clients")
	r_rules.max_per_address = p_options.number("max-per-address")
	r_rules.waiting_room = p_options.is_on("waiting-room")
	r_rules.password = p_options.text("password")
	r_rules.instructor_password = p_options.text("instructor-password")


## Says what changes; of passwords and of what comes later the name alone.
func _describe(p_read: Options) -> void:
	var now: PackedStringArray = []
	var later: PackedStringArray = []
	for name: String in p_read.find_changes(_options):
		if not CHANGEABLE.has(name):
			later.append(name)
		elif name.ends_with("password"):
			now.append(name)
		else:
			now.append("%s %s" % [name, p_read.describe(name)])
	var what: String = ", ".join(now) if not now.is_empty() else "no option"
	Log.info("server", "SIGHUP: configuration and bans were read again; changed: " + what)
	if not later.is_empty():
		Log.warning("server", "these take effect with the next start: " + ", ".join(later))
