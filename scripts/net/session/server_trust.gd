class_name ServerTrust
extends RefCounted
## Decides which key of a server a client accepts: the one that it has seen there before, and any at
## the first time. A password proves more than a key, which is only remembered.
##
## A connection that is lost and made again finds the same key, too. Several clients of one program
## can share one.

## Where keys are kept; null: for the time of this run only.
var servers: KnownServers = null
## The fingerprint that the key has to have, or an empty text.
var pin: String = ""
## Whether a key that has changed is taken, at the first connection to each server.
var takes_new: bool = false
## The key that was not taken at the last attempt, or null.
var other: OtherServerKey = null

# What this run has seen, by address.
var _seen: Dictionary[String, PackedByteArray] = {}


## One that keeps keys in the user's folder, as a client's options ask.
static func of_options(p_options: Options) -> ServerTrust:
	var made: ServerTrust = ServerTrust.new()
	made.servers = KnownServers.new()
	made.pin = p_options.text("server-fingerprint").trim_suffix("=")
	made.takes_new = p_options.is_on("trust-new-key")
	return made


## What is wrong with the options, or an empty text.
func find_fault() -> String:
	var fault: String = KeyFingerprint.find_fault(pin) if pin != "" else ""
	return "--server-fingerprint: " + fault if fault != "" else ""


## A connection begins: the key that it has to find, or nothing if any will do.
func expect(p_address: String) -> PackedByteArray:
	other = null
	if _seen.has(p_address):
		return _seen[p_address]
	if servers == null or takes_new:
		return PackedByteArray()
	var kept: PackedByteArray = servers.find(p_address)
	_tell_faults()
	if not kept.is_empty() and pin != "" and KeyFingerprint.of(kept) != pin:
		# Since then the user has seen another key.
		return PackedByteArray()
	return kept


## A server has proved a key: returns whether it is taken, and remembers it then. A password that it
## has proved besides is enough.
func take(p_address: String, p_key: PackedByteArray, p_has_password: bool) -> bool:
	other = null
	if p_key.is_empty():
		return true
	if pin != "" and KeyFingerprint.of(p_key) != pin:
		_refuse(p_address, pin, p_key, true)
		return false
	var seen: PackedByteArray = _seen.get(p_address, PackedByteArray())
	if seen == p_key:
		return true
	if not seen.is_empty() and not p_has_password:
		refuse(p_address, p_key)
		return false
	var may_replace: bool = p_has_password or pin != "" or takes_new
	if not _keep(p_address, p_key, may_replace):
		refuse(p_address, p_key)
		return false
	return true


## A server has shown a key that is not the expected one: see [member other].
func refuse(p_address: String, p_key: PackedByteArray) -> void:
	var known: PackedByteArray = _seen.get(p_address, PackedByteArray())
	if known.is_empty() and servers != null:
		known = servers.find(p_address)
	_refuse(p_address, KeyFingerprint.of(known), p_key, false)


## The user trusts a key that was refused.
func trust(p_other: OtherServerKey) -> void:
	_seen.erase(p_other.address)
	_keep(p_other.address, p_other.shown, true)


## Remembers a key, unless another one is known that may not be replaced. Returns whether it holds.
func _keep(p_address: String, p_key: PackedByteArray, p_may_replace: bool) -> bool:
	if servers != null:
		var before: PackedByteArray = servers.find(p_address)
		# Another client may have been here meanwhile.
		if servers.keep(p_address, p_key, p_may_replace) != p_key:
			return false
		if before != p_key:
			_tell(p_address, p_key, not before.is_empty())
	_seen[p_address] = p_key
	return true


func _tell(p_address: String, p_key: PackedByteArray, p_is_change: bool) -> void:
	if servers.error != "":
		var fault: String = "the server's key is not remembered: %s"
		Log.limited("client", "known servers", fault % servers.error)
		return
	var text: String = "first time at %s: its key %s is remembered in %s"
	if p_is_change:
		text = "the new key of %s, %s, is remembered in %s"
	Log.info("client", text % [p_address, KeyFingerprint.of(p_key), servers.path])


func _tell_faults() -> void:
	if servers.error != "":
		Log.limited("client", "known servers", "no server is known again: %s" % servers.error)
	for fault: String in servers.faults:
		Log.limited("client", fault, fault)


func _refuse(p_address: String, p_known: String, p_key: PackedByteArray, p_is_pinned: bool) -> void:
	other = OtherServerKey.new()
	other.address = p_address
	other.known = p_known
	other.shown = p_key
	other.is_pinned = p_is_pinned
	var is_kept: bool = servers != null and not servers.find(p_address).is_empty()
	other.source = "as %s has it" % servers.path if is_kept else "as it was before in this run"
