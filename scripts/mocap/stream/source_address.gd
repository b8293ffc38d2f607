class_name SourceAddress
extends RefCounted
## Where a motion source is: what [code]--source=KIND[:ADDRESS][/code] says.

## What follows the kind.
enum Form {
	## Nothing.
	BARE,
	## A UDP port, or nothing.
	PORT,
	## A UDP port, or a TCP address "tcp:HOST:PORT", or nothing.
	PORT_OR_TCP,
	## A host, or nothing.
	HOST,
	## A name.
	NAME,
	## Paths of files, with commas between.
	FILES,
	## The number of a camera, the path of a film, or a UDP port "udp:PORT"; or nothing.
	CAMERA,
}

## How the forms are written, for people.
const FORMS: Dictionary[Form, String] = {
	Form.BARE: "",
	Form.PORT: "[:PORT]",
	Form.PORT_OR_TCP: "[:[tcp:HOST:]PORT]",
	Form.HOST: "[:HOST]",
	Form.NAME: ":NAME",
	Form.FILES: ":FILE",
	Form.CAMERA: "[:NUMBER|FILE|udp:PORT]",
}
## The kinds and what follows each.
const KINDS: Dictionary[String, Form] = {
	"xbus": Form.BARE,
	"mvn": Form.PORT,
	"tracker": Form.NAME,
	"bvh": Form.FILES,
	"vmc": Form.PORT,
	"slime": Form.PORT,
	"rokoko": Form.PORT,
	"axis": Form.PORT_OR_TCP,
	"mocopi": Form.PORT,
	"natnet": Form.HOST,
	"webcam": Form.CAMERA,
	"xr": Form.BARE,
	"walker": Form.BARE,
}
## The greatest number of a camera.
const MAX_CAMERA: int = 63
## The usual ports.
const PORTS: Dictionary[String, int] = {
	"mvn": 9763,
	"vmc": 39539,
	"slime": 6969,
	"rokoko": 14043,
	"axis": 7012,
	"mocopi": 12351,
	"natnet": 1511,
	"webcam": 14050,
}

## One of [constant KINDS].
var kind: String = ""
## The UDP port, or with [member host] of "tcp:" the TCP port; 0 of a camera or film.
var port: int = 0
## The host, or an empty text.
var host: String = ""
## Whether it is a TCP connection to [member host].
var is_tcp: bool = false
## The name of a tracker, paths of files, or the number of a camera.
var text: String = ""
## What is wrong with it, or an empty text.
var fault: String = ""


## Reads one source, such as "vmc:39539" or "axis:tcp:10.0.0.5:7001".
static func parse(p_text: String) -> SourceAddress:
	var found: SourceAddress = SourceAddress.new()
	var colon: int = p_text.find(":")
	found.kind = p_text.left(colon) if colon >= 0 else p_text
	var rest: String = p_text.substr(colon + 1) if colon >= 0 else ""
	if not KINDS.has(found.kind):
		var known: PackedStringArray = PackedStringArray(KINDS.keys())
		var near: String = Nearest.suggest(found.kind, known)
		var parts: Array = [", ".join(describe_kinds()), found.kind.left(40), near]
		found.fault = "a source is one of %s, found '%s'%s" % parts
		return found
	found.port = PORTS.get(found.kind, 0)
	found._read(rest, colon >= 0)
	if found.fault != "":
		found.fault += "; sources are %s" % ", ".join(describe_kinds())
	return found


## Reads several sources with commas between, of which files may have commas too.
static func parse_list(p_text: String) -> Array[SourceAddress]:
	var texts: PackedStringArray = []
	for part: String in p_text.split(",", false):
		var kind: String = part.get_slice(":", 0)
		var is_more: bool = not texts.is_empty() and texts[-1].begins_with("bvh:")
		if is_more and not KINDS.has(kind):
			texts[-1] += "," + part
		else:
			texts.append(part)
	var found: Array[SourceAddress] = []
	for text: String in texts:
		found.append(parse(text))
	return found


## The sources that options name, the short forms (--bvh, --xbus) first.
static func of_options(p_options: Options) -> Array[SourceAddress]:
	var found: Array[SourceAddress] = []
	if p_options.text("bvh") != "":
		found.append(parse("bvh:" + p_options.text("bvh")))
	if p_options.is_on("xbus"):
		found.append(parse("xbus"))
	found.append_array(parse_list(p_options.text("source")))
	return found


## Whether another one names the same source.
func equals(p_other: SourceAddress) -> bool:
	var is_there: bool = host == p_other.host and port == p_other.port and text == p_other.text
	return kind == p_other.kind and is_tcp == p_other.is_tcp and is_there


## Full paths of the files that it names; a file whose own name has commas is one file.
func paths() -> PackedStringArray:
	if FileAccess.file_exists(Options.full_path(text)):
		return [Options.full_path(text)]
	var found: PackedStringArray = []
	for part: String in text.split(",", false):
		found.append(Options.full_path(part))
	return found


## All kinds as they are written: "vmc[:PORT]".
static func describe_kinds() -> PackedStringArray:
	var kinds: PackedStringArray = []
	for name: String in KINDS:
		kinds.append(name + FORMS[KINDS[name]])
	return kinds


## The IPv4 address of a host, or an empty text where there is none of that name.
static func resolve(p_host: String) -> String:
	return p_host if p_host.is_valid_ip_address() else IP.resolve_hostname(p_host, IP.TYPE_IPV4)


## A port from text, 0 where it is none.
static func port_of(p_text: String) -> int:
	var is_number: bool = p_text.is_valid_int() and p_text.length() < 6
	var number: int = p_text.to_int() if is_number else 0
	return number if number >= 1 and number <= 65535 else 0


func _read(p_rest: String, p_is_given: bool) -> void:
	var written: String = kind + FORMS[KINDS[kind]]
	match KINDS[kind]:
		Form.BARE:
			if p_is_given:
				fault = "nothing follows '%s', found '%s'" % [written, p_rest.left(40)]
		Form.NAME, Form.FILES:
			text = p_rest
			if p_rest == "":
				fault = "write %s" % written
		Form.HOST:
			host = p_rest
			var is_bad: bool = p_rest.contains(":") or p_rest.contains("/") or p_rest.contains(" ")
			if (p_is_given and p_rest == "") or is_bad:
				fault = "write %s, found '%s'" % [written, p_rest.left(40)]
		Form.CAMERA:
			_read_camera(p_rest, p_is_given, written)
		_:
			_read_port(p_rest, p_is_given, written)


func _read_camera(p_rest: String, p_is_given: bool, p_written: String) -> void:
	if p_rest.begins_with("udp:"):
		_read_port(p_rest.trim_prefix("udp:"), true, p_written)
		return
	port = 0
	text = p_rest if p_is_given else "0"
	if text == "":
		fault = "write %s" % p_written
	elif text.is_valid_int() and (text.to_int() < 0 or text.to_int() > MAX_CAMERA):
		var parts: Array = [MAX_CAMERA, text.left(40), text.left(40)]
		fault = "cameras are 0 to %d, found '%s'; a port is written webcam:udp:%s" % parts


func _read_port(p_rest: String, p_is_given: bool, p_written: String) -> void:
	var number: String = p_rest
	if KINDS[kind] == Form.PORT_OR_TCP and p_rest.begins_with("tcp:"):
		is_tcp = true
		host = p_rest.get_slice(":", 1)
		number = p_rest.get_slice(":", 2)
		if host == "" or p_rest.get_slice_count(":") != 3:
			fault = "write %s, found '%s'" % [p_written, p_rest.left(40)]
			return
	if not p_is_given:
		return
	var given: int = port_of(number)
	if given == 0:
		fault = "a port is 1 to 65535: write %s, found '%s'" % [p_written, number.left(40)]
		return
	port = given
