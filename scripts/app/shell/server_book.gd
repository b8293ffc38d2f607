class_name ServerBook
extends RefCounted
## What a user's program remembers of servers: favourites, and the last session that was joined.
## Passwords are not among it.

## The file.
const PATH: String = "user://servers.cfg"
## Favourites at most.
const MAX_FAVOURITES: int = 64
const _LAST: String = "last"
const _FAVOURITES: String = "favourites"
const _KEY: String = "addresses"

## Addresses of the favourites, as [ServerAddress] reads them.
var favourites: PackedStringArray = []
## Address of the last server; empty where there was none.
var last_address: String = ""
## The name that the user had there.
var last_name: String = ""

var _path: String = PATH


## Reads the file. Of one that is damaged nothing is taken; it is kept beside under another name.
func _init(p_path: String = PATH) -> void:
	_path = p_path
	if not FileAccess.file_exists(_path):
		return
	var file: ConfigFile = ConfigFile.new()
	if file.load(_path) != OK:
		var kept: String = _path + ".damaged"
		DirAccess.rename_absolute(_path, kept)
		Log.warning("app", "%s cannot be read: it is kept as %s" % [_path, kept])
		return
	var addresses: Variant = file.get_value(_FAVOURITES, _KEY, PackedStringArray())
	if addresses is PackedStringArray:
		for address: String in (addresses as PackedStringArray).slice(0, MAX_FAVOURITES):
			if ServerAddress.parse(address).error == "":
				favourites.append(address)
	var last: Variant = file.get_value(_LAST, "address", "")
	if last is String and ServerAddress.parse(last).error == "":
		last_address = last
	var name: Variant = file.get_value(_LAST, "name", "")
	if name is String:
		last_name = (name as String).left(Protocol.MAX_NAME)


## Whether an address is a favourite.
func has(p_address: String) -> bool:
	return favourites.has(p_address)


## Makes an address a favourite, or no favourite any more.
func toggle(p_address: String) -> void:
	if not has(p_address) and favourites.size() < MAX_FAVOURITES:
		favourites.append(p_address)
	elif has(p_address):
		favourites.remove_at(favourites.find(p_address))
	_save()


## Remembers where the user has joined last, and under which name.
func remember(p_address: String, p_name: String) -> void:
	last_address = p_address
	last_name = p_name
	_save()


func _save() -> void:
	var file: ConfigFile = ConfigFile.new()
	file.set_value(_FAVOURITES, _KEY, favourites)
	file.set_value(_LAST, "address", last_address)
	file.set_value(_LAST, "name", last_name)
	# Whole or not at all, whatever happens meanwhile.
	var part: String = _path + ".part"
	var error: Error = file.save(part)
	if error == OK:
		error = DirAccess.rename_absolute(part, _path)
	if error != OK:
		Log.warning("app", "%s cannot be written: %s" % [_path, error_string(error)])
