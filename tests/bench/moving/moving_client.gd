extends "res://tests/bench/joins/join_client.gd"
## A client whose people move by a recorded clip, at a trainee's rate. It sends what a trainee
## sends, with as little work as possible: all clients of a process share the clip's samples.

const BlindReplica: GDScript = preload("blind_replica.gd")
## Samples a second, of the clip and of each person.
const SAMPLES: int = 60
## Samples in the clip from one person to the next.
const APART: int = 37

## The clip, sample by sample.
static var frames: Array[PoseSample] = []

## Number of this client's first person among all clients' people.
var first: int = 0

var _tick: int = -1


## Reads a clip. Returns what is wrong with it, or an empty text.
static func prepare(p_path: String) -> String:
	var source: BvhSource = BvhSource.new()
	source.open(p_path)
	if source.error != "":
		return source.error
	# After a round, as then its end is blended into its beginning.
	var round_s: float = source.get_period()
	for number: int in int(round_s * SAMPLES):
		frames.append(source.pose_at(round_s + float(number) / SAMPLES))
	return ""


## Makes it cheap: no thread of its own, as two processors could not wake so many, and who moves
## does not look.
func save_work() -> void:
	rate = SAMPLES
	_link.has_thread = false
	if not heights.is_empty():
		_replica = BlindReplica.new(tables)


func _rides_along(p_ack: PackedByteArray) -> bool:
	return not heights.is_empty() and _writer.take_along(p_ack)


func _pose(p_person: int) -> PoseSample:
	var frame: PoseSample = frames[(_sample + (first + p_person) * APART) % frames.size()]
	var pose: PoseSample = PoseSample.new()
	pose.orientations = frame.orientations
	pose.root = frame.root
	if _link.clock.is_known():
		pose.sent_usec = _link.clock.server_usec(_now())
	return pose


## Of an observer a snapshot is a tick's, however many datagrams it has.
func _on_state(p_bytes: PackedByteArray, p_arrival_usec: int) -> void:
	var before: int = snapshots
	super(p_bytes, p_arrival_usec)
	if snapshots > before and heights.is_empty():
		snapshots = before if _replica.decoder.get_tick() == _tick else snapshots
		_tick = _replica.decoder.get_tick()
