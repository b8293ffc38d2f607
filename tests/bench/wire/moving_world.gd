extends Node3D
## A world for the benchmarks of the wire: people who play clips, and crates that are pushed about
## in the real physics, so that they slide, tumble, fly and collide all the time.

const SIDE_M: float = 24.0
## Seconds from one push of a crate to the next, on average.
const PUSH_S: float = 1.5

var people: Array[BvhSource] = []
var crates: Array[RigidBody3D] = []

var _random: RandomNumberGenerator = RandomNumberGenerator.new()


func _init(p_people: Array[BvhSource], p_crates: int) -> void:
	people = p_people
	_random.seed = 11
	_add_walls()
	for i: int in p_crates:
		var crate: RigidBody3D = RigidBody3D.new()
		crate.mass = 10.0
		crate.add_child(BenchBodies.box(Vector3.ONE * 0.5))
		crate.position = Vector3(i % 15 - 7, 1.0 + 0.01 * i, i / 15 - 7)
		add_child(crate)
		crates.append(crate)


## Where a person's root and limbs are at a time, s: everybody at another place of the clip.
func pose(p_person: int, p_time_s: float) -> PoseSample:
	var source: BvhSource = people[p_person]
	var sample: PoseSample = source.pose_at(p_time_s + 3.7 * p_person)
	sample.root += Vector3(p_person % 4 * 2.0 - 4.0, 0.0, p_person / 4 * 2.0 - 4.0)
	return sample


## Pushes some of the crates, before a step.
func push(p_delta_s: float) -> void:
	for crate: RigidBody3D in crates:
		if _random.randf() < p_delta_s / PUSH_S:
			var way: Vector3 = Vector3(
				_random.randfn(), 0.6 * absf(_random.randfn()), _random.randfn()
			)
			var lever: Vector3 = Vector3(_random.randfn(), _random.randfn(), _random.randfn()) * 0.1
			crate.apply_impulse(way * 20.0, lever)


func _add_walls() -> void:
	var half: float = SIDE_M / 2.0
	for wall: Array in [
		[Vector3(SIDE_M, 1.0, SIDE_M), Vector3(0.0, -0.5, 0.0)],
		[Vector3(SIDE_M, 1.0, SIDE_M), Vector3(0.0, 6.5, 0.0)],
		[Vector3(1.0, 8.0, SIDE_M), Vector3(half, 3.0, 0.0)],
		[Vector3(1.0, 8.0, SIDE_M), Vector3(-half, 3.0, 0.0)],
		[Vector3(SIDE_M, 8.0, 1.0), Vector3(0.0, 3.0, half)],
		[Vector3(SIDE_M, 8.0, 1.0), Vector3(0.0, 3.0, -half)],
	]:
		var body: StaticBody3D = StaticBody3D.new()
		body.add_child(BenchBodies.box(wall[0]))
		body.position = wall[1]
		add_child(body)
