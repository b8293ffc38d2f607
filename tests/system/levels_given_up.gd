extends SceneTree
## Gives levels up in a window, in all the ways a client does, before a frame is drawn with them.
## The engine says at its end what nobody has freed.

const NAME: String = "hall"
const FRAMES: int = 3

var _loader: LevelLoader = LevelLoader.new()


func _initialize() -> void:
	_give_up.call_deferred()


func _give_up() -> void:
	await _draw()
	_give_up_loading()
	await _draw()
	_give_up_reading()
	await _draw()
	_give_up_read()
	await _draw()
	_give_up_shown()
	await _draw()
	print("gave up all")
	_loader.close()
	quit()


## While the engine's threads load the scene.
func _give_up_loading() -> void:
	_loader.begin_own(NAME)
	_loader.cancel()
	_await_scene()
	_loader.advance()


## While a thread makes the level.
func _give_up_reading() -> void:
	_begin_reading()
	_loader.cancel()
	OS.delay_msec(500)
	_loader.advance()


## When it could have entered the tree.
func _give_up_read() -> void:
	_begin_reading()
	while _loader.state == LevelLoader.State.READING:
		OS.delay_msec(10)
		_loader.advance()
	_loader.cancel()
	while _loader.is_leaving():
		_loader.advance()


## When it is in the tree, and another one is named.
func _give_up_shown() -> void:
	var level: ClientLevel = ClientLevel.new()
	root.add_child(level)
	for name: String in [NAME, NAME, "yard"]:
		level.set_level(name, [])
	level.free()


func _begin_reading() -> void:
	_loader.begin_own(NAME)
	_await_scene()
	_loader.advance()


func _await_scene() -> void:
	var path: String = LevelStore.path_of(NAME)
	var loading: ResourceLoader.ThreadLoadStatus = ResourceLoader.THREAD_LOAD_IN_PROGRESS
	while ResourceLoader.load_threaded_get_status(path) == loading:
		OS.delay_msec(10)


func _draw() -> void:
	for _frame: int in FRAMES:
		await RenderingServer.frame_post_draw
