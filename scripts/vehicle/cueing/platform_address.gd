class_name PlatformAddress
extends RefCounted
## The address of a motion platform and the format of its datagrams: [code]HOST:PORT[/code] for our
## own format, [code]HOST:PORT:outsim[/code] or, with an id, [code]HOST:PORT:outsim-7[/code] for
## OutSim's.

## How it is written, for help.
const FORM: String = "HOST:PORT[:outsim[-ID]]"

## What is wrong with the text it was read from; empty if nothing is.
var error: String = ""
## Name or number of the host, such as 127.0.0.1 or ::1.
var host: String = ""
## UDP port.
var port: int = 0
## What is sent.
var format: PlatformSender.Format = PlatformSender.FORMAT_OWN
## OutSim's id, with [constant PlatformSender.FORMAT_OUTSIM_WITH_ID].
var outsim_id: int = 1


## Reads an address; see [member error].
static func parse(p_text: String) -> PlatformAddress:
	var address: PlatformAddress = PlatformAddress.new()
	var rest: String = p_text.strip_edges()
	# An IPv6 number has colons of its own: [::1]:4123.
	if rest.begins_with("["):
		address.host = rest.get_slice("]", 0).substr(1)
		rest = rest.substr(rest.find("]") + 1).trim_prefix(":")
		if not p_text.contains("]:"):
			rest = ""
	else:
		address.host = rest.get_slice(":", 0)
		rest = rest.substr(address.host.length()).trim_prefix(":")
	var parts: PackedStringArray = rest.split(":")
	if address.host == "" or rest == "" or parts.size() > 2:
		address.error = "a platform's address is %s, found '%s'" % [FORM, p_text]
	elif not parts[0].is_valid_int() or parts[0].to_int() < 1 or parts[0].to_int() > 65535:
		address.error = "a platform's port is 1 to 65535, found '%s'" % parts[0]
	else:
		address.port = parts[0].to_int()
		address._read_format(parts[1] if parts.size() > 1 else "")
	return address


func _read_format(p_text: String) -> void:
	if p_text == "":
		return
	var id: String = p_text.trim_prefix("outsim-")
	if p_text == "outsim":
		format = PlatformSender.FORMAT_OUTSIM
	elif id != p_text and id.is_valid_int() and id.to_int() > 0 and id.to_int() < 1 << 31:
		format = PlatformSender.FORMAT_OUTSIM_WITH_ID
		outsim_id = id.to_int()
	else:
		error = (
			"a platform is sent outsim, outsim-ID or, without a word, our own; found '%s'" % p_text
		)
