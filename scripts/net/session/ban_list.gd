class_name BanList
extends RefCounted
## Banned addresses, kept in a file: a JSON list of texts. An IPv6 address stands for its /64.

## Why the file cannot be used, or an empty text.
var error: String = ""

var _path: String = ""
var _addresses: Dictionary[String, bool] = {}
var _networks: Dictionary[String, bool] = {}


## Reads a file; a missing one is created with the first ban. Entries that are no addresses are
## logged and left out.
static func open(p_path: String) -> BanList:
	var list: BanList = BanList.new()
	list._path = p_path
	if p_path == "" or not FileAccess.file_exists(p_path):
		return list
	var text: String = FileAccess.get_file_as_string(p_path)
	var json: JSON = JSON.new()
	if json.parse(text) != OK:
		var parts: Array = [p_path, json.get_error_line() + 1, json.get_error_message()]
		list.error = "%s:%d: the list of bans is no JSON: %s" % parts
	elif json.data is not Array:
		list.error = "%s: the list of bans is no JSON list of addresses" % p_path
	else:
		list._read(json.data, text)
	return list


## Whether an address is banned.
func has(p_address: String) -> bool:
	return _networks.has(AddressNetwork.of(p_address))


## Bans an address and keeps it. Returns why it cannot be kept, or an empty text.
func add(p_address: String) -> String:
	_take(p_address)
	if _path == "":
		return ""
	var file: FileAccess = FileAccess.open(_path + ".part", FileAccess.WRITE)
	if file == null:
		return "cannot write %s: %s" % [_path, error_string(FileAccess.get_open_error())]
	file.store_string(JSON.stringify(_addresses.keys(), "\t") + "\n")
	file.close()
	return (
		"" if DirAccess.rename_absolute(_path + ".part", _path) == OK else "cannot write " + _path
	)


func _take(p_address: String) -> void:
	_addresses[p_address] = true
	_networks[AddressNetwork.of(p_address)] = true


func _read(p_entries: Array, p_text: String) -> void:
	var lines: PackedStringArray = p_text.split("\n")
	for entry: Variant in p_entries:
		if entry is String and (entry as String).is_valid_ip_address():
			_take(entry)
			continue
		var shown: String = JSON.stringify(entry)
		var number: int = 1
		while number < lines.size() and not lines[number - 1].contains(shown):
			number += 1
		var parts: Array = [_path, number, ByteReader.clean(shown).left(60)]
		Log.warning("net", "%s:%d: %s is no address; it bans nobody" % parts)
