class_name LevelLoader
extends RefCounted
## Loads a level while everything else goes on: a thread reads it, and its pieces enter the tree
## over several ticks or frames. No tick waits for more than [constant BUDGET_USEC] and one piece.

## The state of a load.
enum State {
	## Nothing is loaded.
	IDLE,
	## A thread reads the level.
	READING,
	## The level is read; it waits for [method enter].
	READ,
	## Its pieces enter the tree.
	ENTERING,
	## It is in the tree as a whole.
	DONE,
	## It cannot be loaded: see [member fault].
	FAILED,
}

## Time that [method advance] may take of a tick, µs.
const BUDGET_USEC: int = 3000

## How far it has come.
var state: State = State.IDLE
## Name of the level.
var name: String = ""
## The level, from [constant State.READ] on.
var level: Level = null
## Its fingerprint, once it is in the tree.
var fingerprint: PackedByteArray = PackedByteArray()
## Why it cannot be loaded, or an empty text.
var fault: String = ""
## Whether a thread reads. If not, all is read at once: for programs without a window whose main
## thread makes meshes or textures at any time. See [RenderLock].
var has_thread: bool = true

var _job: Job = null
var _thread: Thread = null
# Jobs that nobody waits for any more, with their threads.
var _abandoned: Array[Array] = []
# Scenes that the engine still loads and nobody waits for: it keeps what is never asked for.
var _unclaimed: PackedStringArray = []
var _hashing: LevelFingerprint = null
var _props_mode: Node.ProcessMode = Node.PROCESS_MODE_INHERIT
# Nodes that are to be freed, the last one first, which may have children.
var _leaving: Array = []


## What a thread does.
class Job:
	extends RefCounted
	## Path of the program's own scene; empty where there is a folder.
	var scene_path: String = ""
	## A folder with a manifest.
	var folder: LevelFolder = null
	## Hash that the folder's manifest has to have; empty for any.
	var wanted_hash: String = ""
	## The level that was read.
	var level: Level = null
	## Its pieces.
	var assembly: LevelAssembly = null
	## Why there is none.
	var fault: String = ""

	## The program's own scene, once the engine has loaded it.
	var scene: PackedScene = null
	## The skies that came with it.
	var skies: Array[Sky] = []

	## Reads the level, in a thread. The engine lets a thread that has loaded something wait for the
	## main thread's next frame, which therefore must not wait for this: see
	## [method LevelLoader.end_reading].
	func run() -> void:
		RenderLock.hold()
		_read()
		RenderLock.release()

	func _read() -> void:
		if folder == null:
			_make_own()
		elif not folder.open():
			fault = folder.error
		elif wanted_hash not in ["", folder.manifest.content_hash()]:
			fault = "the manifest is not the one that was asked for"
		else:
			level = folder.build()
			fault = folder.error
		if level != null:
			skies = UntilDrawn.skies_of(level)
			_read_ahead()
			level.prepare()
			assembly = LevelAssembly.take_apart(level)

	## Whether the engine is still loading the program's own scene, in threads of its own.
	func is_loading() -> bool:
		var loading: ResourceLoader.ThreadLoadStatus = ResourceLoader.THREAD_LOAD_IN_PROGRESS
		return folder == null and ResourceLoader.load_threaded_get_status(scene_path) == loading

	## How much of reading is done, 0 to 1.
	func progress() -> float:
		if folder != null:
			return folder.total_progress()
		var share: Array = [1.0]
		if scene == null and not RenderLock.is_needed():
			ResourceLoader.load_threaded_get_status(scene_path, share)
		return share[0]

	## Nodes that read large files have a method for it, so that no tick waits for them.
	func _read_ahead() -> void:
		for node: Node in [level] + level.find_children("*", "", true, false):
			if node.has_method(&"read_ahead"):
				node.call(&"read_ahead")

	func _make_own() -> void:
		if scene == null:
			scene = ResourceLoader.load(scene_path, "PackedScene") as PackedScene
		var node: Node = scene.instantiate() if scene != null else null
		level = node as Level
		if level == null:
			fault = "the scene %s is broken: its root must be a Level" % scene_path
			if node != null:
				node.free()


## Begins with a level of the program's own, which [LevelStore] has.
func begin_own(p_name: String) -> void:
	var job: Job = Job.new()
	job.scene_path = LevelStore.path_of(p_name)
	_begin(p_name, job)
	if RenderLock.is_needed():
		# The engine's own threads do not know of the lock.
		_start_thread()
	else:
		ResourceLoader.load_threaded_request(job.scene_path, "PackedScene")


## Begins with a level in a folder; its manifest is to have this hash, or any if it is empty.
func begin_folder(p_name: String, p_path: String, p_hash: String = "") -> void:
	var job: Job = Job.new()
	job.folder = LevelFolder.new(p_path)
	job.wanted_hash = p_hash
	_begin(p_name, job)
	_start_thread()


## Whether a level is being loaded.
func is_busy() -> bool:
	return state == State.READING or state == State.READ or state == State.ENTERING


## Gives up what is being read, and returns when no thread reads any more, in a frame that has yet
## to be drawn (see [UntilDrawn]). Await it before [method close], which would wait for ever for a
## thread that waits for a frame.
func end_reading(p_tree: SceneTree) -> void:
	if state == State.READING:
		cancel()
	_collect_abandoned()
	while not (_abandoned.is_empty() and _unclaimed.is_empty()):
		await p_tree.process_frame
		_collect_abandoned()


## The folder of the level that was read; null for one of the program's own.
func folder() -> LevelFolder:
	return _job.folder if _job != null else null


## How much is done, 0 to 1: reading is the first half, entering the tree the second.
func progress() -> float:
	match state:
		State.READING:
			return 0.5 * _job.progress()
		State.READ:
			return 0.5
		State.ENTERING:
			return 0.5 + 0.5 * _job.assembly.progress()
	return 1.0


## Puts the root of the level that was read below a node; the pieces follow when what leaves is
## gone. Nothing below its props root moves before all are there.
func enter(p_parent: Node) -> void:
	if level.props_root != null:
		_props_mode = level.props_root.process_mode
		level.props_root.process_mode = Node.PROCESS_MODE_DISABLED
	p_parent.add_child(level)
	state = State.ENTERING


## Does a part of the work. Call it once a tick or frame.
func advance() -> void:
	var until: int = Time.get_ticks_usec() + BUDGET_USEC
	_collect_abandoned()
	if state == State.READING:
		_look_at_job()
	if not _free_some(until):
		return
	if state == State.ENTERING and _job.assembly.add_until(until):
		if _hashing == null:
			# In the next tick: to find the nodes takes a while too.
			_hashing = LevelFingerprint.new(level)
		elif _hashing.advance_until(until):
			fingerprint = _hashing.finish()
			_hashing = null
			if level.props_root != null:
				level.props_root.process_mode = _props_mode
			state = State.DONE


## Takes a level that is in the tree away, over the next ticks. See [method is_leaving].
func dismiss(p_level: Node) -> void:
	# As a whole, before others take its path: the engine follows these nodes one by one.
	var shared: SharedNodes = SharedNodes.find_in(p_level)
	if shared != null:
		shared.get_parent().remove_child(shared)
		shared.free()
	# The next level may have its name.
	p_level.name = &"Leaving"
	var leaving: Level = p_level as Level
	if leaving != null and leaving.props_root != null:
		# Scripts must not look for what has gone already.
		leaving.props_root.process_mode = Node.PROCESS_MODE_DISABLED
	_leaving.append(p_level)


## Whether a level is still being taken away.
func is_leaving() -> bool:
	return not _leaving.is_empty()


## Gives up what is being loaded.
func cancel() -> void:
	if state == State.READING and _thread != null:
		_abandoned.append([_job, _thread])
	elif state == State.READING:
		_unclaimed.append(_job.scene_path)
	elif state == State.READ or state == State.ENTERING:
		_job.assembly.free_rest()
		dismiss(level)
	_hashing = null
	level = null
	state = State.IDLE


## Ends: waits for threads (see [method end_reading]), and frees what nobody has taken over.
func close() -> void:
	cancel()
	for pair: Array in _abandoned:
		_finish(pair)
	_abandoned.clear()
	for path: String in _unclaimed:
		ResourceLoader.load_threaded_get(path)
	_unclaimed.clear()
	_free_some(1 << 62)


func _begin(p_name: String, p_job: Job) -> void:
	cancel()
	name = p_name
	fault = ""
	fingerprint = PackedByteArray()
	_job = p_job
	_thread = null
	state = State.READING


func _start_thread() -> void:
	if not has_thread:
		_job.run()
		_take_job()
		return
	_thread = Thread.new()
	_thread.start(_job.run, Thread.PRIORITY_LOW)


func _look_at_job() -> void:
	if _thread == null:
		if not _job.is_loading():
			_job.scene = ResourceLoader.load_threaded_get(_job.scene_path) as PackedScene
			_start_thread()
	elif not _thread.is_alive():
		_thread.wait_to_finish()
		_take_job()


func _take_job() -> void:
	UntilDrawn.keep(_job)
	level = _job.level
	fault = _job.fault
	state = State.READ if level != null else State.FAILED


## Frees nodes until a moment. Returns whether all are gone.
func _free_some(p_until: int) -> bool:
	while not _leaving.is_empty():
		var last: Variant = _leaving.back()
		# A script may have freed it with another one.
		if is_instance_valid(last) and _is_divided(last):
			_leaving.append_array((last as Node).get_children(true))
		else:
			_leaving.pop_back()
			if is_instance_valid(last):
				(last as Node).free()
		if Time.get_ticks_usec() >= p_until:
			break
	return _leaving.is_empty()


## Whether the children of a node go one by one before it: not those of scenes and of nodes with
## scripts, which may rely on them to the last.
static func _is_divided(p_node: Node) -> bool:
	if p_node.get_child_count(true) == 0:
		return false
	return p_node is Level or LevelAssembly.is_group(p_node)


func _collect_abandoned() -> void:
	for index: int in range(_abandoned.size() - 1, -1, -1):
		if not (_abandoned[index][1] as Thread).is_alive():
			_finish(_abandoned[index])
			_abandoned.remove_at(index)
	var loading: ResourceLoader.ThreadLoadStatus = ResourceLoader.THREAD_LOAD_IN_PROGRESS
	for index: int in range(_unclaimed.size() - 1, -1, -1):
		if ResourceLoader.load_threaded_get_status(_unclaimed[index]) != loading:
			UntilDrawn.keep(ResourceLoader.load_threaded_get(_unclaimed[index]))
			_unclaimed.remove_at(index)


static func _finish(p_pair: Array) -> void:
	(p_pair[1] as Thread).wait_to_finish()
	var job: Job = p_pair[0]
	UntilDrawn.keep(job)
	if job.level != null:
		job.assembly.free_rest()
		job.level.free()
