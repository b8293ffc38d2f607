class_name ServerRules
extends RefCounted
## Whom a server admits, and how.

## [member max_per_address]: a quarter of [member max_clients], but [constant MIN_SHARE] at least.
const QUARTER: int = -1
## Clients of one address that every server takes, if it takes as many at all.
const MIN_SHARE: int = 4
## Shares that all addresses of a site have together: see [method AddressNetwork.site_of].
const SITE_SHARES: int = 2

## Maximum of clients.
var max_clients: int = Protocol.DEFAULT_MAX_CLIENTS
## Maximum of clients from one address, those included whose connection is lost; 0 for no limit.
var max_per_address: int = QUARTER
## Password of all roles; empty if there is none.
var password: String = ""
## Password of instructors; empty if it is the others'.
var instructor_password: String = ""
## Whether an instructor admits each of the others.
var waiting_room: bool = false
## Banned addresses.
var bans: BanList = BanList.new()
## Whether connections are sealed.
var seals: bool = true
## What the server's key pair is made from; see [ServerKeyFile]. By default good for this run.
var server_key: PackedByteArray = Crypto.new().generate_random_bytes(KeyFingerprint.KEY_SIZE)
## Name of the level that a client needs.
var level_name: String = ""
## Fingerprint of the level at the server, [constant Protocol.FINGERPRINT_SIZE] bytes.
var level_fingerprint: PackedByteArray = PackedByteArray()

var _salt: PackedByteArray = Crypto.new().generate_random_bytes(16)
var _keys: Dictionary[String, PackedByteArray] = {}


## Maximum of clients from one address, as a number; 0 for no limit.
func share_of_address() -> int:
	if max_per_address != QUARTER:
		return max_per_address
	return maxi(ceili(max_clients / 4.0), MIN_SHARE)


## The password of a role; empty if it needs none.
func password_of(p_role: Roles.Role) -> String:
	var moderates: bool = Roles.can(p_role, Roles.Capability.MODERATE)
	var own: bool = moderates and instructor_password != ""
	return instructor_password if own else password


## The key of a role's password.
func key_of(p_role: Roles.Role) -> PackedByteArray:
	var secret: String = password_of(p_role)
	if not _keys.has(secret):
		_keys[secret] = PasswordKey.derive(secret, _salt, PasswordKey.ROUNDS)
	return _keys[secret]


## Fingerprint of the server's key; empty without sealing.
func fingerprint() -> String:
	return KeyFingerprint.of(ServerKeyFile.public_key_of(server_key)) if seals else ""


## How connections are sealed.
func sealing() -> TransportSealing:
	var made: TransportSealing = TransportSealing.new()
	made.seals = seals
	made.version = Protocol.VERSION
	made.server_key = server_key
	for role: Roles.Role in Roles.Role.values():
		made.passwords.append(password_of(role))
	return made


## A new challenge.
func challenge() -> Challenge:
	var made: Challenge = Challenge.new()
	made.salt = _salt
	made.nonce = Crypto.new().generate_random_bytes(32)
	made.locked_roles = locked_roles()
	return made


## Bit r is set where the role of number r needs a password.
func locked_roles() -> int:
	var bits: int = 0
	for role: Roles.Role in Roles.Role.values():
		bits |= (1 << role) if password_of(role) != "" else 0
	return bits


## Whether an address is this machine's own.
static func is_loopback(p_address: String) -> bool:
	return p_address.begins_with("127.") or p_address == "::1" or p_address == "0:0:0:0:0:0:0:1"
