extends RefCounted
## A server's real port that answers who looks for it, on this machine.

const LinkPair: GDScript = preload("res://tests/net/link_pair.gd")

var link: ServerLink = ServerLink.new()
var said: ServerAnnouncement = ServerAnnouncement.new()
var port: int = 0


## Opens a free port; null if there is none.
static func open(p_name: String, p_seals: bool = true) -> RefCounted:
	var made: RefCounted = new()
	made.said.name = p_name
	made.said.run = Crypto.new().generate_random_bytes(8).decode_s64(0)
	var rules: ServerRules = ServerRules.new()
	rules.seals = p_seals
	made.port = LinkPair.free_port()
	if made.link.listen(made.port, rules, "127.0.0.1") != OK:
		return null
	made.announce()
	return made


## Says what has changed.
func announce() -> void:
	link.announcement = said.encode()


func close() -> void:
	link.close()
