extends TestCase
## Loading over several ticks: the same level as at once, no long tick, and nothing is left behind.

var _loader: LevelLoader = LevelLoader.new()


func goes_by_clock() -> bool:
	return true


func before_each() -> void:
	SampleFolder.clean_up()


func after_each() -> void:
	await _loader.end_reading(get_tree())
	_loader.close()
	SampleFolder.clean_up()


func test_a_level_of_ours_is_the_same_as_at_once() -> void:
	for name: String in ["hall", "yard"]:
		var wanted: Level = LevelStore.instantiate(name)
		add_child(wanted)
		var print: PackedByteArray = LevelFingerprint.of(wanted)
		var tree: String = _describe(wanted)
		var mode: ProcessMode = wanted.props_root.process_mode
		wanted.free()
		_loader.begin_own(name)
		equal(await _load(), LevelLoader.State.DONE)
		equal(_loader.fingerprint, print, name)
		equal(_describe(_loader.level), tree)
		equal(_loader.level.props_root.process_mode, mode)
		equal(_loader.level.static_root.get_child(0).owner, _loader.level)
		_loader.level.free()


func test_nobody_makes_meshes_while_a_thread_loads() -> void:
	# This thread has the lock, so that the other one waits: the engine may crash otherwise.
	RenderLock.hold()
	_loader.begin_own("hall")
	for _frame: int in 20:
		_loader.advance()
		await get_tree().process_frame
	equal(_loader.state, LevelLoader.State.READING, "it waits for who has the lock")
	RenderLock.release()
	equal(await _load(), LevelLoader.State.DONE)
	is_true(RenderLock.try_hold(), "it has given the lock back")
	RenderLock.release()
	_loader.level.free()


func test_without_a_thread_all_is_read_at_once() -> void:
	_loader.has_thread = false
	_loader.begin_own("hall")
	equal(_loader.state, LevelLoader.State.READ)
	equal(await _load(), LevelLoader.State.DONE)
	_loader.level.free()


func test_a_folder_is_loaded_if_it_is_the_one_that_was_asked_for() -> void:
	var path: String = SampleFolder.make("range", 100)
	_loader.begin_folder("range", path)
	equal(await _load(), LevelLoader.State.DONE)
	var hash: String = _loader.folder().manifest.content_hash()
	_loader.level.free()
	_loader.begin_folder("range", path, hash)
	equal(await _load(), LevelLoader.State.DONE)
	_loader.level.free()
	_loader.begin_folder("range", path, "ab".repeat(32))
	equal(await _load(), LevelLoader.State.FAILED)
	contains(_loader.fault, "not the one that was asked for")
	_loader.begin_folder("range", path + "x")
	equal(await _load(), LevelLoader.State.FAILED)
	contains(_loader.fault, "level.json is missing")


func test_a_large_level_takes_many_ticks_and_progress_grows() -> void:
	var text: PackedStringArray = [LevelTexts.level()]
	for index: int in 600:
		var block: String = '[node name="B%d" type="StaticBody3D" parent="Static"]\n' % index
		text.append(block + 'script = ExtResource("block")\nsize = Vector3(1, 2, 0.3)\n')
	var source: String = SampleFolder.ROOT.path_join("source/large")
	DirAccess.make_dir_recursive_absolute(source)
	SampleFolder.store(source.path_join("large.tscn"), "\n".join(text).to_utf8_buffer())
	var archive: LevelArchive = LevelArchive.new()
	is_true(archive.pack("large", source, SampleFolder.ROOT), " ".join(archive.faults))
	_loader.begin_folder("large", SampleFolder.ROOT.path_join("large"))
	var entering: int = 0
	var last: float = 0.0
	while _loader.state != LevelLoader.State.DONE:
		_loader.advance()
		if _loader.state == LevelLoader.State.READ:
			_loader.enter(self)
		entering += 1 if _loader.state == LevelLoader.State.ENTERING else 0
		is_true(_loader.progress() >= last, "%f after %f" % [_loader.progress(), last])
		last = _loader.progress()
		await process_frames(1)
	is_true(entering > 2, "%d ticks" % entering)
	equal(_loader.level.get_static_bodies().size(), 601)
	_loader.dismiss(_loader.level)
	_loader.advance()
	is_true(_loader.is_leaving())
	while _loader.is_leaving():
		_loader.advance()
	equal(find_children("B5*", "", true, false).size(), 0)


func test_what_is_given_up_leaves_nothing() -> void:
	var before: int = int(Performance.get_monitor(Performance.OBJECT_NODE_COUNT))
	for _time: int in 3:
		_loader.begin_own("yard")
		_loader.cancel()
	_loader.begin_own("hall")
	while _loader.state != LevelLoader.State.READ:
		_loader.advance()
		await process_frames(1)
	_loader.enter(self)
	_loader.advance()
	await _loader.end_reading(get_tree())
	_loader.close()
	await process_frames(2)
	equal(int(Performance.get_monitor(Performance.OBJECT_NODE_COUNT)), before)


func test_who_ends_while_a_thread_reads_lets_frames_pass() -> void:
	for is_given_up: bool in [false, true]:
		_loader.begin_own("town")
		if is_given_up:
			_loader.cancel()
		equal(_loader.is_busy(), not is_given_up)
		await _loader.end_reading(get_tree())
		is_false(_loader.is_busy())
		_loader.close()


func _load() -> LevelLoader.State:
	while _loader.is_busy():
		_loader.advance()
		if _loader.state == LevelLoader.State.READ:
			_loader.enter(self)
		await process_frames(1)
	return _loader.state


static func _describe(p_level: Level) -> String:
	var lines: PackedStringArray = []
	for node: Node in p_level.find_children("*", "", true, true):
		lines.append("%s %s" % [p_level.get_path_to(node), node.get_class()])
	return "\n".join(lines)
