class_name RenderLock
extends RefCounted
## Lets one thread at a time make meshes, materials and textures, in a program without a window.
##
## The engine's renderer for programs without a window keeps its lists without a lock, though those
## of all other renderers have one: two threads that load or make such things at once, such as a
## level in a thread and an avatar in the main thread, corrupt the heap (godotengine/godot#121949,
## Godot 4.6.3). Whoever may do so while another thread loads something holds this lock. With a
## window nothing is locked and nobody waits.

static var _mutex: Mutex = Mutex.new()


## Whether the engine's renderer needs it.
static func is_needed() -> bool:
	return DisplayServer.get_name() == "headless"


## Takes the lock; waits for who has it. For threads of their own only: a thread that loads now and
## then waits for the main thread's next frame, and both would wait for ever.
static func hold() -> void:
	if is_needed():
		_mutex.lock()


## Takes the lock if nobody has it. Returns whether the caller holds it now.
static func try_hold() -> bool:
	return not is_needed() or _mutex.try_lock()


## Gives the lock back.
static func release() -> void:
	if is_needed():
		_mutex.unlock()
