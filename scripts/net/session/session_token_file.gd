class_name SessionTokenFile
extends RefCounted
## Keeps the token of a client's session on disk, so that a client that was killed and is started
## anew comes back into its session, and its body.
##
## There is a file for each server, role and name, readable by its owner alone. Clients that run at
## the same time under one name have a file each: nobody takes over the session of one that runs.

## Folder of the files.
const FOLDER: String = "user://sessions"
## Clients of one name on one machine that can come back.
const MAX_SLOTS: int = 64
## Time without use after which a file is removed, s: no server keeps a session that long.
const STALE_S: int = 86400

var _file: PrivateFile = null


## The file of a client that nobody else uses, for the server at [param p_where]. Never null: where
## the disk refuses, nothing is kept.
static func claim(p_where: String, p_role: int, p_name: String) -> SessionTokenFile:
	var claimed: SessionTokenFile = SessionTokenFile.new()
	var folder: String = ProjectSettings.globalize_path(FOLDER)
	var error: Error = DirAccess.make_dir_recursive_absolute(folder)
	if error == OK:
		_remove_stale(folder)
	var whose: String = "\n".join([p_where, Roles.name_of(p_role), p_name]).sha256_text().left(24)
	for slot: int in MAX_SLOTS:
		var file: PrivateFile = PrivateFile.new()
		error = file.open("%s/%s-%d.token" % [folder, whose, slot]) if error == OK else error
		if error == OK:
			claimed._file = file
			return claimed
		if error != ERR_BUSY:
			break
		error = OK
	var parts: Array = [folder, error_string(error if error != OK else ERR_BUSY)]
	Log.warning("client", "after a crash this client cannot come back: %s: %s" % parts)
	return claimed


## The token that was kept last, or nothing.
func token() -> PackedByteArray:
	if _file == null:
		return PackedByteArray()
	var kept: PackedByteArray = _file.read()
	return kept if kept.size() == JoinRequest.TOKEN_SIZE else PackedByteArray()


## Keeps a token.
func keep(p_token: PackedByteArray) -> void:
	if _file != null and _file.write(p_token) != OK:
		Log.limited("client", "token", "the disk is full: no coming back after a crash")


## The session is over: there is nothing to come back to.
func forget() -> void:
	if _file != null:
		_file.remove()
		_file = null


static func _remove_stale(p_folder: String) -> void:
	var oldest: int = int(Time.get_unix_time_from_system()) - STALE_S
	for name: String in DirAccess.get_files_at(p_folder):
		var path: String = p_folder.path_join(name)
		var file: PrivateFile = PrivateFile.new()
		# Who has it open may have been in its session for longer than that.
		if FileAccess.get_modified_time(path) < oldest and file.open(path) == OK:
			file.remove()
