class_name FoundServer
extends RefCounted
## A server that a [code]ServerFinder[/code] has found or was asked to look for.

## Rounds of questions without an answer after which a server counts as gone.
const MAX_MISSED: int = 3

## Where it is: what the user joins.
var address: ServerAddress = ServerAddress.new()
## What it has said of itself last; null before its first answer.
var announcement: ServerAnnouncement = null
## The least of its last delays there and back, s.
var delay_s: float = 0.0
## Rounds of questions since its last answer; 1 while the present one may still be answered.
var missed: int = 0
## Whether the user asked for this address: it stays though nothing answers.
var is_wanted: bool = false

var _delays_s: PackedFloat32Array = []


## Its key in the list: address and port.
func key() -> String:
	return key_of(address.host, address.port)


## The key of an address and a port.
static func key_of(p_host: String, p_port: int) -> String:
	return "%s %d" % [p_host, p_port]


## Whether it has answered lately.
func answers() -> bool:
	return announcement != null and missed <= MAX_MISSED


## What it is called: as it says, else its address.
func title() -> String:
	return announcement.name if announcement != null and announcement.name != "" else describe()


## Its address, for people.
func describe() -> String:
	return address.describe()


## Whether it speaks this program's version of the protocol.
func is_same_version() -> bool:
	return announcement == null or announcement.protocol == Protocol.VERSION


## Whether a role needs a password there, as far as it is known.
func needs_password(p_role: Roles.Role) -> bool:
	return announcement != null and announcement.locked_roles & (1 << p_role) != 0


## Takes in an answer. Returns whether anything in it is news.
func take(p_said: ServerAnnouncement, p_delay_s: float) -> bool:
	var is_news: bool = not answers() or announcement.encode() != p_said.encode()
	announcement = p_said
	missed = 0
	_delays_s.append(p_delay_s)
	if _delays_s.size() > 5:
		_delays_s.remove_at(0)
	var sorted: PackedFloat32Array = _delays_s.duplicate()
	sorted.sort()
	var before: int = roundi(delay_s * 1e3)
	delay_s = sorted[0]
	return is_news or roundi(delay_s * 1e3) != before
