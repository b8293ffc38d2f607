class_name AvatarArrival
extends RefCounted
## Loads the avatars of people who join, in a thread: in a headset a picture that stops for half a
## second is felt. Those people are shown when their avatar is loaded.

## Whether people wait for a thread; without a window nobody sees a picture stop.
var waits: bool = DisplayServer.get_name() != "headless"

## People whose avatars are being loaded, by the numbers of their entities.
var _waiting: Dictionary[int, EntityRow] = {}
## Paths of scenes that are being loaded.
var _loading: Dictionary[String, bool] = {}
## Loaded scenes are kept: people who leave may come back.
var _kept: Dictionary[String, PackedScene] = {}


## Loads an avatar at once: that of a client's own people, before it joins.
func keep(p_name: String) -> void:
	var path: String = AvatarStore.path_of(p_name)
	if path != "":
		_kept[path] = load(path) as PackedScene


## Whether a person has to wait; then [method take_ready] gives the row back later.
func holds_up(p_row: EntityRow) -> bool:
	var path: String = AvatarStore.path_of(p_row.path)
	if not waits or path == "" or _kept.has(path):
		return false
	if not _loading.has(path):
		if ResourceLoader.has_cached(path) or ResourceLoader.load_threaded_request(path) != OK:
			return false
		_loading[path] = true
	_waiting[p_row.id] = p_row
	return true


## Somebody who waited has left.
func forget(p_id: int) -> void:
	_waiting.erase(p_id)


## The rows whose avatars are loaded now.
func take_ready() -> Array[EntityRow]:
	for path: String in _loading.keys():
		var status: ResourceLoader.ThreadLoadStatus = ResourceLoader.load_threaded_get_status(path)
		if status != ResourceLoader.THREAD_LOAD_IN_PROGRESS:
			_take(path)
	var ready: Array[EntityRow] = []
	for id: int in _waiting.keys():
		if not _loading.has(AvatarStore.path_of(_waiting[id].path)):
			ready.append(_waiting[id])
			_waiting.erase(id)
	return ready


## Waits for what is being loaded: the program ends.
func finish() -> void:
	_waiting.clear()
	for path: String in _loading.keys():
		_take(path)


func _take(p_path: String) -> void:
	_loading.erase(p_path)
	_kept[p_path] = ResourceLoader.load_threaded_get(p_path) as PackedScene
