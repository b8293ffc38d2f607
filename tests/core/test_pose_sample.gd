extends TestCase
## What is a pose and what is not.

const NetSamples: GDScript = preload("../net/net_samples.gd")

var _random: RandomNumberGenerator = RandomNumberGenerator.new()


func before_each() -> void:
	_random.seed = 1


func test_keeps_what_is_set() -> void:
	var sample: PoseSample = PoseSample.new()
	var turns: Array[Quaternion] = []
	for limb: int in Limbs.COUNT:
		turns.append(NetSamples.rotation(_random))
		sample.set_orientation(limb, turns[limb])
	for limb: int in Limbs.COUNT:
		equal(sample.orientation(limb), turns[limb])
	equal(sample.orientations.size(), Limbs.COUNT * 4)


func test_faults() -> void:
	for _round: int in 50:
		equal(NetSamples.pose(_random).find_fault(), "")
	contains(PoseSample.new().find_fault(), "0 floats instead of 64")
	var sample: PoseSample = NetSamples.pose(_random)
	sample.orientations.resize(65)
	contains(sample.find_fault(), "65 floats")
	for limb: int in Limbs.COUNT:
		sample = NetSamples.pose(_random)
		sample.set_orientation(limb, sample.orientation(limb) * 1.2)
		contains(sample.find_fault(), "%s has no rotation" % Limbs.BONES[limb])
		sample.set_orientation(limb, Quaternion(0.0, NAN, 0.0, 1.0))
		contains(sample.find_fault(), "%s has no rotation" % Limbs.BONES[limb])
	sample = NetSamples.pose(_random)
	for root: Vector3 in [Vector3(INF, 0, 0), Vector3(0, NAN, 0), Vector3(0, 0, 1e5)]:
		sample.root = root
		contains(sample.find_fault(), "root")
