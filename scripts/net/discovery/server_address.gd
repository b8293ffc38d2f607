class_name ServerAddress
extends RefCounted
## Where a server is, as a person types it: a name or an address, and a port.
##
## [code]HOST[/code], [code]HOST:PORT[/code], [code]1.2.3.4:7777[/code], [code]2001:db8::1[/code],
## [code][2001:db8::1]:7777[/code]; a link's own address with its link, [code]fe80::1%eth0[/code].

## Longest name that the domain name system has.
const MAX_HOST: int = 253
const _MAX_PORT: int = 65535
const _MAX_PORT_DIGITS: int = 5
const _MAX_LINK: int = 15

## Name or IP address, in lower case, without brackets.
var host: String = ""
## UDP port.
var port: int = Protocol.DEFAULT_PORT
## Why the text is no address, as a sentence that is translated; empty if it is one.
var error: String = ""


## Reads what a person has typed. Where it is no address, [member error] says why.
static func parse(p_text: String) -> ServerAddress:
	var made: ServerAddress = ServerAddress.new()
	var text: String = p_text.strip_edges()
	if text.length() > MAX_HOST + 2 + _MAX_PORT_DIGITS:
		made.error = made.tr("This is too long for an address.")
	elif text == "":
		made.error = made.tr("Type the name or address of a server.")
	elif text.begins_with("["):
		made._read_bracketed(text)
	elif text.count(":") > 1:
		made._take_host(text)
	elif text.contains(":"):
		made._take_host(text.get_slice(":", 0))
		made._take_port(text.get_slice(":", 1))
	else:
		made._take_host(text)
	return made


## As a person would type it, without the port where that is the usual one.
func describe() -> String:
	var is_usual: bool = port == Protocol.DEFAULT_PORT
	if host.contains(":"):
		return host if is_usual else "[%s]:%d" % [host, port]
	return host if is_usual else "%s:%d" % [host, port]


## Whether it is an address and no name, so that nothing has to be looked up.
func is_numeric() -> bool:
	return host.get_slice("%", 0).is_valid_ip_address()


func _read_bracketed(p_text: String) -> void:
	var end: int = p_text.find("]")
	if end < 0:
		error = tr("The bracket before the address is not closed.")
		return
	_take_host(p_text.substr(1, end - 1))
	var rest: String = p_text.substr(end + 1)
	if error == "" and not host.contains(":"):
		error = tr("Only an IPv6 address stands in brackets.")
	elif rest.begins_with(":"):
		_take_port(rest.substr(1))
	elif rest != "":
		error = tr("Behind the bracket only a colon and a port can stand.")


func _take_port(p_text: String) -> void:
	if error != "":
		return
	var is_number: bool = p_text.is_valid_int() and p_text.length() <= _MAX_PORT_DIGITS
	is_number = is_number and not p_text.begins_with("+")
	port = p_text.to_int() if is_number else 0
	if port < 1 or port > _MAX_PORT:
		error = tr("A port is a number from 1 to 65535.")


func _take_host(p_text: String) -> void:
	host = p_text.to_lower().trim_suffix(".")
	var address: String = host.get_slice("%", 0)
	if address.contains(":"):
		var link: String = host.substr(address.length() + 1) if host.contains("%") else "-"
		if not address.is_valid_ip_address() or not _is_word(link) or link.length() > _MAX_LINK:
			error = tr("This is no IPv6 address.")
		# Names of links differ by their case.
		host = address + p_text.substr(address.length())
		return
	var is_dotted: bool = address.replace(".", "").is_valid_int()
	if is_dotted and not address.is_valid_ip_address():
		error = tr("This is no IPv4 address.")
	elif host.length() > MAX_HOST or not _is_name(host):
		error = tr("A name has letters, digits, hyphens and dots only.")


static func _is_name(p_text: String) -> bool:
	for label: String in p_text.split("."):
		if not _is_word(label) or label.begins_with("-") or label.ends_with("-"):
			return false
	return true


static func _is_word(p_text: String) -> bool:
	for byte: int in p_text.to_utf8_buffer():
		var is_digit: bool = byte >= 0x30 and byte <= 0x39
		var is_letter: bool = (byte | 0x20) >= 0x61 and (byte | 0x20) <= 0x7A
		if not is_digit and not is_letter and byte != 0x2D and byte != 0x5F and byte != 0x2E:
			return false
	return p_text != ""
