extends TestCase
## Motion sets of single people: what is read, what is refused, and that hostile bytes are no more
## than that.

const MadeSets: GDScript = preload("made_sets.gd")
const ROUNDS: int = 400


func test_a_set_is_read_and_named_by_its_bytes() -> void:
	var bytes: PackedByteArray = MadeSets.small()
	var own: WalkerSet = WalkerSet.read(bytes)
	equal(own.error, "")
	equal(own.motion.get_clip_count(), 2)
	equal(own.id, FileAccess.get_sha256(_write(bytes)).left(16))
	is_true(WalkerSet.read(FileAccess.get_file_as_bytes(WalkerPose.DEFAULT_SET)).id != own.id)


func test_what_is_refused_says_why() -> void:
	var small: PackedByteArray = MadeSets.small()
	equal(_fault([]), "this is no motion set")
	equal(_fault("RIFF____________".to_ascii_buffer()), "this is no motion set")
	contains(_fault(small.slice(0, 1000)), "the motion set ends within clip")
	equal(_fault(MadeSets.of(["stand"])), "it lacks walking ahead: nobody can walk by it")
	equal(_fault(MadeSets.of(["slow walk"])), "it lacks standing: nobody can walk by it")
	var large: PackedByteArray = small.duplicate()
	large.resize(MotionSetMessage.MAX_BYTES + 1)
	contains(_fault(large), "it is larger than 1.6 MB")


func test_what_a_walker_does_by_damaged_bytes_stays_a_pose() -> void:
	var random: RandomNumberGenerator = RandomNumberGenerator.new()
	random.seed = 11
	var small: PackedByteArray = MadeSets.small()
	var read: int = 0
	for _round: int in ROUNDS:
		var bytes: PackedByteArray = small.duplicate()
		for _hit: int in random.randi_range(1, 3):
			bytes[random.randi_range(6, bytes.size() - 1)] = random.randi() & 255
		var own: WalkerSet = WalkerSet.read(bytes)
		if own.error != "":
			continue
		read += 1
		var matcher: MotionMatcher = MotionMatcher.new()
		matcher.set_motion_set(own.motion)
		matcher.set_body(0.95, PackedFloat32Array())
		matcher.reset(Vector3.ZERO, 0.0)
		var wish: Vector3 = Vector3(0.0, 0.0, 1.5)
		for tick: int in 20:
			matcher.advance(1.0 / 60.0, wish * tick / 60.0, wish, 0.0, wish, 0.0, 0, true)
		var pose: PoseSample = PoseSample.new()
		pose.orientations = matcher.get_orientations()
		pose.root = matcher.get_root()
		if pose.find_fault() != "":
			fail(pose.find_fault())
	is_true(read > 20 and read < ROUNDS, "%d were read" % read)


func test_somebody_who_walks_changes_sets_without_a_jump() -> void:
	var own: WalkerSet = WalkerSet.read(MadeSets.small())
	var shipped: MotionSet = MotionSet.new()
	equal(shipped.load_file(WalkerPose.DEFAULT_SET), "")
	for speed: float in [0.0, 1.4, 3.2]:
		var velocity: Vector3 = Vector3(0.0, 0.0, speed)
		var matcher: MotionMatcher = MotionMatcher.new()
		matcher.set_motion_set(shipped)
		matcher.set_body(0.95, PackedFloat32Array())
		matcher.reset(Vector3.ZERO, 0.0)
		var last: PoseSample = null
		for tick: int in 400:
			if tick % 60 == 59:
				matcher.change_motion_set(shipped if tick % 120 > 60 else own.motion)
			var place: Vector3 = velocity * tick / 60.0
			matcher.advance(1.0 / 60.0, place, velocity, 0.0, velocity, 0.0, 0, true)
			var sample: PoseSample = PoseSample.new()
			sample.orientations = matcher.get_orientations()
			sample.root = matcher.get_root() - place
			equal(sample.find_fault(), "")
			for limb: int in Limbs.COUNT:
				if tick > 30 and sample.orientation(limb).angle_to(last.orientation(limb)) > 0.35:
					fail("limb %d jumps in tick %d at %.1f m/s" % [limb, tick, speed])
			if tick > 30 and sample.root.distance_to(last.root) > 0.02:
				fail("hips jump in tick %d at %.1f m/s" % [tick, speed])
			last = sample


func _fault(p_bytes: PackedByteArray) -> String:
	var own: WalkerSet = WalkerSet.read(p_bytes)
	equal(own.motion, null)
	return own.error


func _write(p_bytes: PackedByteArray) -> String:
	var path: String = "user://test_walker_set.motionset"
	var file: FileAccess = FileAccess.open(path, FileAccess.WRITE)
	file.store_buffer(p_bytes)
	file.close()
	return path
