extends Bench
## Levels from elsewhere: how long the reader takes for a large one, and the ticks in which it
## enters the tree; what a download adds to the delay of snapshots; that hostile and mutated levels
## do nothing and are refused with a reason soon.
##
## Options: --blocks=2000, --mutations=100000, --seed=1.

## Goal for so many blocks, ms.
const _GOAL_READ_MS: float = 1500.0
## Goal for saying no, ms.
const _GOAL_REFUSE_MS: float = 50.0
## Goal for the part of a tick that loading takes, ms.
const _GOAL_TICK_MS: float = 8.0
## Fewest kinds of hostile levels.
const _GOAL_KINDS: float = 40.0

## Goal for how much later a datagram of the fast path comes while its client downloads, ms: half a
## tick.
const _GOAL_DELAY_MS: float = 8.0
const _TICK_USEC: int = 16667
## Bytes that are downloaded.
const _DOWNLOAD: int = 8 << 20

const LinkPair: GDScript = preload("res://tests/net/link_pair.gd")


func options() -> Dictionary:
	return {"blocks": 2000, "mutations": 100000, "seed": 1}


func measure() -> void:
	HostileLevels.clean_up()
	HostileLevels.write_bait()
	_measure_reader()
	await _measure_loader()
	_measure_download()
	_measure_hostile()
	_measure_mutations()
	HostileLevels.clean_up()


## A level of so many blocks, as the editor saves it.
func _large() -> PackedByteArray:
	var parts: PackedStringArray = [LevelTexts.level()]
	for index: int in option("blocks"):
		var at: Array = [index % 50 * 2.0, index / 50 * 3.0]
		parts.append('[node name="Block%d" type="StaticBody3D" parent="Static"]' % index)
		parts.append("transform = Transform3D(1, 0, 0, 0, 1, 0, 0, 0, 1, %f, 0.5, %f)" % at)
		parts.append('collision_layer = 1\ncollision_mask = 0\nscript = ExtResource("block")')
		parts.append('size = Vector3(1.5, 2.8, 0.3)\nmaterial = SubResource("stone")\n')
	return "\n".join(parts).to_utf8_buffer()


func _measure_reader() -> void:
	var bytes: PackedByteArray = _large()
	var name: String = "%d blocks" % option("blocks")
	var begin: int = ThreadClock.get_usec()
	var reader: LevelReader = LevelReader.new()
	var level: Level = reader.build(bytes, "large.tscn")
	var took_ms: float = (ThreadClock.get_usec() - begin) / 1000.0
	if level == null:
		report.leave_out(name, reader.refusal)
		return
	report.at_most(name, "read", took_ms, "ms", _GOAL_READ_MS)
	report.add(name, "size of the scene", bytes.size() / 1024.0, "KiB")
	level.free()


## Lets a large level enter the tree, and leave it, as a server does.
func _measure_loader() -> void:
	var name: String = "%d blocks enter" % option("blocks")
	var source: String = "user://bench_levels/large"
	DirAccess.make_dir_recursive_absolute(source)
	FileAccess.open(source.path_join("large.tscn"), FileAccess.WRITE).store_buffer(_large())
	var archive: LevelArchive = LevelArchive.new()
	archive.pack("large", source, "user://bench_levels/share")
	var loader: LevelLoader = LevelLoader.new()
	loader.begin_folder("large", "user://bench_levels/share/large")
	var begin: int = Time.get_ticks_msec()
	var slices: PackedFloat32Array = []
	var is_dismissed: bool = false
	while not is_dismissed or loader.is_leaving():
		await physics_frame
		var slice: int = ThreadClock.get_usec()
		loader.advance()
		if loader.state == LevelLoader.State.READ:
			loader.enter(root)
		elif loader.state == LevelLoader.State.DONE:
			loader.state = LevelLoader.State.IDLE
			report.add(name, "until it is there", Time.get_ticks_msec() - begin, "ms")
			loader.dismiss(loader.level)
			is_dismissed = true
		slices.append((ThreadClock.get_usec() - slice) / 1000.0)
		if loader.state == LevelLoader.State.FAILED:
			report.leave_out(name, loader.fault)
			return
	slices.sort()
	report.at_most(name, "longest tick", slices[-1], "ms", _GOAL_TICK_MS)
	report.add(name, "ticks", slices.size(), "")
	for file: String in ["share/large/large.tscn", "share/large/level.json", "large/large.tscn"]:
		DirAccess.remove_absolute("user://bench_levels/" + file)
	for folder: String in ["share/large", "share", "large", ""]:
		DirAccess.remove_absolute("user://bench_levels/" + folder)


## Lets a client download a level while it gets a datagram in each tick.
func _measure_download() -> void:
	SampleFolder.clean_up()
	SampleFolder.make("range", _DOWNLOAD)
	var level: ServerLevel = ServerLevel.new()
	root.add_child(level)
	level.share = LevelShare.new(SampleFolder.ROOT.path_join("share"))
	level.load_level("range")
	var pair: LinkPair = LinkPair.new()
	pair.listen()
	var offers: LevelOffers = LevelOffers.new(pair.server, level)
	var link: ClientLink = pair.join(Roles.Role.OBSERVER).link
	var store: ReceivedLevels = ReceivedLevels.new(SampleFolder.ROOT.path_join("store"))
	var download: LevelDownload = LevelDownload.new(link.send_reliably, store)
	link.handle(
		Protocol.Message.LEVEL_DATA,
		MessageHandlers.Path.RELIABLE,
		func(bytes: PackedByteArray, _arrival_usec: int) -> bool: return download.take(bytes)
	)
	var delays: Array[float] = []
	link.state_received.connect(
		func(bytes: PackedByteArray, arrival_usec: int) -> void:
			if bytes.size() == 12 and bytes[0] == Protocol.Message.KEY:
				delays.append((arrival_usec - bytes.decode_u64(4)) / 1000.0)
	)
	var quiet_ms: float = _percentile(_run_ticks(pair, offers, download, delays, 120), 0.95)
	delays.clear()
	var begin: int = Time.get_ticks_usec()
	download.begin(LevelReference.parse(level.reference))
	var busy_ms: float = _percentile(_run_ticks(pair, offers, download, delays, 0), 0.95)
	var seconds: float = (Time.get_ticks_usec() - begin) / 1e6
	var name: String = "download of 8 MB"
	report.at_most(
		name, "not got", 0.0 if store.has(download.manifest.content_hash()) else 1.0, "", 0.0
	)
	report.add(name, "rate", download.here * 8.0 / 1e6 / seconds, "Mbit/s")
	report.add(name, "p95 of a datagram before", quiet_ms, "ms")
	report.add(name, "p95 of a datagram meanwhile", busy_ms, "ms")
	report.at_most(name, "p95 that it adds", busy_ms - quiet_ms, "ms", _GOAL_DELAY_MS)
	offers.close()
	pair.close()
	level.free()
	SampleFolder.clean_up()


## Makes so many ticks, or as many as the download takes (0). Returns the delays, ms.
func _run_ticks(
	p_pair: LinkPair,
	p_offers: LevelOffers,
	p_download: LevelDownload,
	r_delays: Array[float],
	p_ticks: int
) -> Array[float]:
	var left: int = p_ticks
	while left > 0 or (p_ticks == 0 and p_download.is_busy()):
		left -= 1
		var end: int = Time.get_ticks_usec() + _TICK_USEC
		var bytes: PackedByteArray = [Protocol.Message.KEY]
		bytes.resize(12)
		bytes.encode_u64(4, Time.get_ticks_usec())
		p_pair.server.send_datagrams(p_pair.server.session_ids(), [bytes])
		p_offers.advance(_TICK_USEC / 1e6)
		while Time.get_ticks_usec() < end:
			p_pair.poll()
			p_download.advance(0.002)
			OS.delay_usec(2000)
	return r_delays


static func _percentile(p_values: Array[float], p_share: float) -> float:
	var sorted: Array[float] = p_values.duplicate()
	sorted.sort()
	return sorted[int(p_share * (sorted.size() - 1))] if not sorted.is_empty() else INF


func _measure_hostile() -> void:
	var kinds: Dictionary[String, Array] = HostileLevels.all()
	var longest_ms: float = 0.0
	var unnamed: int = 0
	for kind: String in kinds:
		var begin: int = ThreadClock.get_usec()
		var reader: LevelReader = LevelReader.new()
		var level: Level = reader.build(kinds[kind][0], "hostile.tscn")
		longest_ms = maxf(longest_ms, (ThreadClock.get_usec() - begin) / 1000.0)
		if level != null or not reader.refusal.contains(kinds[kind][1]):
			printerr("%s: %s" % [kind, reader.refusal])
			unnamed += 1
		if level != null:
			level.free()
	var name: String = "hostile"
	report.at_least(name, "kinds", kinds.size(), "", _GOAL_KINDS)
	report.at_most(name, "acted", HostileLevels.marks().size(), "", 0.0)
	report.at_most(name, "not refused by name", unnamed, "", 0.0)
	report.at_most(name, "longest refusal", longest_ms, "ms", _GOAL_REFUSE_MS)


func _measure_mutations() -> void:
	var mutations: LevelMutations = LevelMutations.new(option("seed"))
	var longest_ms: float = 0.0
	var unnamed: int = 0
	var strange: int = 0
	var read: int = 0
	for _count: int in option("mutations"):
		var bytes: PackedByteArray = mutations.next()
		var begin: int = ThreadClock.get_usec()
		var reader: LevelReader = LevelReader.new()
		var level: Level = reader.build(bytes, "mutated.tscn")
		longest_ms = maxf(longest_ms, (ThreadClock.get_usec() - begin) / 1000.0)
		if level == null:
			unnamed += 0 if reader.refusal.begins_with("mutated.tscn") else 1
		else:
			read += 1
			strange += 0 if LevelMutations.find_stranger(level) == "" else 1
			level.free()
	var name: String = "%d mutated" % option("mutations")
	report.at_most(name, "acted", HostileLevels.marks().size() + strange, "", 0.0)
	report.at_most(name, "refused without a reason", unnamed, "", 0.0)
	report.at_most(name, "longest", longest_ms, "ms", _GOAL_REFUSE_MS)
	report.add(name, "that are sound levels still", read, "")
