extends Bench
## What a frame costs a client's main thread: everybody evaluated and posed, crates moved.
##
## Through the scene that a client shows, from real snapshots of real motion, without a window: what
## the graphics card and its driver do is not in it. Options: --people=64, --crates=200 (half of
## them at rest), --seconds=4, --bvh=FILE.

const Motion: GDScript = preload("smoothing/smoothing_motion.gd")
const _CLIENT: PackedScene = preload("res://scenes/client/client.tscn")
const HZ: int = 60
## Goal for a person and frame, evaluated and posed, µs.
const _GOAL_USEC: float = 40.0
const _FIRST_PERSON: int = 1
## Distance between people, m.
const _SPACING_M: float = 1.2
const _FIRST_CRATE: int = 1024
## A client's share, bit/s: enough for all.
const _BITS: float = 1e9

var _client: Node = null
var _scene: ClientScene = null
var _motion: Motion = null
var _person_type: EntityType = null
var _encoder: SnapshotEncoder = SnapshotEncoder.new()
var _tick: int = 1000
var _people: int = 0
var _crates: int = 0


func options() -> Dictionary:
	return {"people": [64, 1, 1000], "crates": [200, 0, 4000], "seconds": 4.0, "bvh": ""}


func find_fault() -> String:
	_people = option("people")
	_crates = option("crates")
	return _open_motion()


func measure() -> void:
	var all: float = await _time_frames(_people, _crates)
	var people: float = await _time_frames(_people, 0)
	var none: float = await _time_frames(0, 0)
	var name: String = "%d people" % _people
	report.at_most(name, "a person and frame", (people - none) / _people, "us", _GOAL_USEC)
	if _crates > 0:
		name = "%d people, %d crates" % [_people, _crates]
		report.add(name, "a crate and frame", (all - people) / _crates, "us")
	report.add(name, "frame", all / 1000.0, "ms")


## The median time of a frame of so many people and crates, µs.
func _time_frames(p_people: int, p_crates: int) -> float:
	_build(p_people, p_crates)
	await process_frame
	var times: Statistics = Statistics.new()
	var frames: int = int(option("seconds") * HZ)
	for frame: int in frames + HZ / 2:
		_play(p_people, p_crates)
		var begin: int = Time.get_ticks_usec()
		_scene.update(_tick / float(HZ))
		if frame >= HZ / 2:
			times.add(Time.get_ticks_usec() - begin)
		if frame % 16 == 0:
			await process_frame
	var shown: int = 0
	for node: Node3D in _scene.get_node(^"People").get_children():
		shown += int(node.visible)
	if shown != p_people:
		printerr("%d of %d people are shown" % [shown, p_people])
	_scene.free()
	_client.free()
	return times.percentile(0.5)


func _build(p_people: int, p_crates: int) -> void:
	# Only the scene: the client's own node would connect to a server.
	_client = _CLIENT.instantiate()
	_scene = _client.get_node(^"Scene")
	_client.remove_child(_scene)
	_scene.owner = null
	root.add_child(_scene)
	_scene.apply("mesh,static", "")
	_encoder = SnapshotEncoder.new()
	_encoder.configure(PackedInt32Array(Limbs.PARENTS), Protocol.POSE_ERROR_DEG, HZ)
	_encoder.add_client(1, 0, _BITS)
	var message: EntityTableMessage = EntityTableMessage.new()
	message.is_full = true
	message.types = [_person_type, EntityType.new()]
	message.types[1].name = &"prop"
	message.types[1].body = EntityType.Body.RIGID
	for person: int in p_people:
		message.spawned.append(_row(_FIRST_PERSON + person, message.types[0], ""))
	var hall: Level = LevelStore.instantiate("hall")
	root.add_child(hall)
	_scene.replica.take(LevelMessage.encode("hall", LevelFingerprint.of(hall)), 0.0)
	hall.free()
	for crate: int in p_crates:
		var copy: Node = _scene.get_level().level.get_node(^"Props/Crate1").duplicate()
		_scene.get_level().level.get_node(^"Props").add_child(copy)
		var path: String = "Props/%s" % copy.name
		message.spawned.append(_row(_FIRST_CRATE + crate, message.types[1], path))
		message.spawned[-1].type_number = 1
	_scene.replica.take(message.encode(), 0.0)


## Lets the client take a tick of the server.
func _play(p_people: int, p_crates: int) -> void:
	_tick += 1
	_encoder.begin_tick(_tick)
	for person: int in p_people:
		var sample: int = (_tick * 4 + person * 37) % _motion.count
		var place: Vector3 = Vector3(person % 8, 0.0, person / 8) * _SPACING_M
		var root_there: Vector3 = _motion.roots[sample] + place
		_encoder.put_person(_FIRST_PERSON + person, root_there, _motion.turns_of(sample))
	for crate: int in p_crates:
		var at_rest: bool = crate % 2 == 0
		var place: Vector3 = Vector3(crate, 0.0 if at_rest else fmod(_tick * 0.02, 5.0), 0.0)
		var speed: Vector3 = Vector3.ZERO if at_rest else Vector3.UP
		var transform: Transform3D = Transform3D(Basis(), place)
		_encoder.put_body(_FIRST_CRATE + crate, transform, speed, Vector3.ZERO, at_rest)
	_encoder.end_tick()
	for bytes: PackedByteArray in _encoder.encode(1, 0):
		_scene.replica.take(bytes, _tick / float(HZ))
	_encoder.take_ack(1, _scene.replica.acknowledgement(_tick * 1000000 / HZ, Vector3.ZERO))


func _open_motion() -> String:
	var person: Ragdoll = _scene_of_person().instantiate()
	var skeleton: PersonSkeleton = person.get_joints()
	_person_type = Entity.find_in(person).type
	person.free()
	var source: BvhSource = BvhSource.new()
	source.open(BenchArguments.clips(arguments)[0])
	if source.error != "":
		return source.error
	_motion = Motion.new(source, skeleton, minf(source.rig.clip.duration() - 1.0, 8.0))
	return ""


func _row(p_id: int, p_type: EntityType, p_path: String) -> EntityRow:
	var row: EntityRow = EntityRow.new()
	row.id = p_id
	row.type = p_type
	row.path = p_path if p_path != "" else AvatarStore.NAMES[p_id % AvatarStore.NAMES.size()]
	row.source = EntityRow.Source.LEVEL
	row.values = p_type.spawn_schema().defaults()
	row.skeleton = _motion.skeleton
	row.owner = 7
	return row


static func _scene_of_person() -> PackedScene:
	return load("res://scenes/actor/person.tscn") as PackedScene
