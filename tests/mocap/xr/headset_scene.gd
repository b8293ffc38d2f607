extends RefCounted
## Somebody in a suit and a headset, of whom all is known: a clip is the truth, of which the headset
## and the controllers show their part exactly, and the suit the whole with a heading that drifts,
## noise, and limbs whose lengths are wrong.

const CLIPS: String = "res://assets/motion/"

## Rate of samples, Hz.
var rate: float = 60.0
## Heading of the suit against the truth at the beginning, and its drift, rad and rad/s.
var heading: float = 0.0
var drift: float = 0.0
## Noise of each limb's rotation, rad.
var noise: float = 0.0
## The suit's limbs by the true ones.
var length_ratio: float = 1.0
## How the headset sits on the head, and the true lever of the eyes.
var mount: Quaternion = Quaternion.IDENTITY
var lever: Vector3 = HeadMount.USUAL_LEVER
## Whether the suit knows the way.
var travels: bool = true
## The clip's place of which it goes on: standing still where the scale of time is 0.
var pace: float = 1.0
var from_s: float = 0.0
## What is true at the last moment.
var truth: PoseSample = null
## Where all limbs are then.
var figure: BodySegments = null
## The last frame of the devices and sample of the suit.
var frame: XrFrame = XrFrame.new()
var suit: PoseSample = null
## Seconds since the beginning.
var time_s: float = 0.0

var _clip: BvhSource = BvhSource.new()
var _size: BodySize = null
var _random: RandomNumberGenerator = RandomNumberGenerator.new()
var _rest: BodySegments = null
var _wander: Vector3 = Vector3.ZERO
var _rounds: int = 0


func _init(p_clip: String, p_seed: int = 1) -> void:
	_clip.open(p_clip if p_clip.contains("/") else CLIPS + p_clip)
	_size = _clip.get_body()
	figure = BodySegments.new(_size)
	_random.seed = p_seed


## Whether there is a clip.
func error() -> String:
	return _clip.error


## The size that the suit's source takes the wearer to have.
func size() -> BodySize:
	return BodySize.of_height(_size.height * length_ratio)


## Duration of a round of the clip, s.
func period() -> float:
	return _clip.get_period()


## Goes on by one sample.
func advance() -> void:
	time_s += 1.0 / rate
	look(from_s + time_s * pace)


## The moment of a sample, µs.
func now_usec() -> int:
	return 1_000_000_000 + roundi(time_s * 1e6)


## Sets truth, suit and devices to a moment of the clip, s.
func look(p_clip_s: float) -> void:
	# A round that begins anew goes on where the last one ended.
	var rounds: int = floori(p_clip_s / period())
	if rounds > _rounds:
		var gone: Vector3 = _clip.pose_at(period() - 1e-4).root - _clip.pose_at(0.0).root
		_wander += Vector3(gone.x, 0.0, gone.z)
		_rounds = rounds
	truth = _clip.pose_at(fposmod(p_clip_s, period()))
	truth.root += _wander
	truth.time_usec = now_usec()
	figure.solve(truth)
	_set_devices()
	_set_suit()


## Turns the head, seen from the chest, at the moment that is there.
func nod(p_turn: Quaternion) -> void:
	truth.set_orientation(Limbs.HEAD, truth.orientation(Limbs.CHEST) * p_turn)
	figure.solve(truth)
	_set_devices()
	_set_suit()


func _set_devices() -> void:
	frame.time_usec = now_usec()
	var head: Quaternion = truth.orientation(Limbs.HEAD)
	var neck: Quaternion = truth.orientation(Limbs.CHEST).slerp(head, 0.5)
	var above: float = _size.height * BodySize.EYE_HEIGHT + HeadMount.USUAL_LEVER.y
	var pivot: Vector3 = figure.bases[Limbs.HEAD]
	pivot += neck * Vector3(0.0, above - figure.rest_base(Limbs.HEAD).y, 0.0)
	var worn: Quaternion = (head * mount).normalized()
	frame.head = Transform3D(Basis(worn * Quaternion(Vector3.UP, PI)), pivot - worn * lever)
	frame.has_head = true
	frame.has_place = true
	for side: int in 2:
		var hand: int = Limbs.LEFT_HAND + 3 * side
		frame.hands[side] = Transform3D(Basis(truth.orientation(hand)), figure.bases[hand])
		frame.has_hands[side] = 1


func _set_suit() -> void:
	suit = PoseSample.new()
	suit.time_usec = truth.time_usec
	var turn: Quaternion = Rotations.yaw(heading + drift * time_s)
	for limb: int in Limbs.COUNT:
		var off: Vector3 = Vector3(_random.randfn(), _random.randfn(), _random.randfn()) * noise
		var rotation: Quaternion = Rotations.from_vector(off) * truth.orientation(limb)
		suit.set_orientation(limb, (turn * rotation).normalized())
	suit.root = Vector3(0.0, truth.root.y, 0.0)
	if travels:
		suit.root = turn * truth.root
	suit.root.y *= length_ratio
