extends RefCounted
## The motion that a network is to carry: a clip, sampled finely, on a person's skeleton.

## Samples of the truth per second.
const RATE: int = 240

## Where the limbs are, m: all limbs of the first sample, then of the second.
var places: PackedVector3Array = PackedVector3Array()
## Four floats for each limb of each sample.
var turns: PackedFloat32Array = PackedFloat32Array()
## Root's place of each sample, m.
var roots: PackedVector3Array = PackedVector3Array()
## Number of samples.
var count: int = 0
## The skeleton.
var skeleton: PersonSkeleton = null


## Samples a source for so many seconds.
func _init(p_source: BvhSource, p_skeleton: PersonSkeleton, p_seconds: float) -> void:
	skeleton = p_skeleton
	count = int(p_seconds * RATE)
	var limbs: int = skeleton.count()
	for i: int in count:
		var sample: PoseSample = p_source.pose_at(float(i) / RATE)
		var floats: PackedFloat32Array = sample.orientations
		var root: Vector3 = skeleton.root_of(sample, sample.root)
		turns.append_array(floats)
		roots.append(root)
		_place(floats, root, limbs)


## Adds the motions that a benchmark's arguments ask for; those that cannot be shown are noted.
static func open_all(p_arguments: BenchArguments, p_report: BenchReport, r_motions: Array) -> void:
	var soldier: Ragdoll = BenchBodies.soldier()
	var bones: PersonSkeleton = soldier.get_joints()
	soldier.free()
	for file: String in BenchArguments.clips(p_arguments):
		var source: BvhSource = p_report.open_clip(file)
		if source == null:
			continue
		var seconds: float = minf(source.rig.clip.duration() - 1.0, p_arguments.value("seconds"))
		if seconds < 4.0:
			p_report.leave_out(file, "it is shorter than 5 s")
			continue
		r_motions.append(new(source, bones, seconds))


## Orientations of a sample, four floats a limb.
func turns_of(p_sample: int) -> PackedFloat32Array:
	var floats: int = skeleton.count() * 4
	return turns.slice(p_sample * floats, (p_sample + 1) * floats)


## Forward kinematics, here apart from what is measured.
func _place(p_floats: PackedFloat32Array, p_root: Vector3, p_limbs: int) -> void:
	var first: int = places.size()
	var orientations: Array[Quaternion] = []
	places.append(p_root)
	orientations.append(_turn(p_floats, 0))
	for limb: int in range(1, p_limbs):
		var parent: int = skeleton.parents[limb]
		orientations.append(_turn(p_floats, limb))
		var joint: Vector3 = (
			places[first + parent] + orientations[parent] * skeleton.joints_in_parent[limb]
		)
		places.append(joint - orientations[limb] * skeleton.joints_in_limb[limb])


static func _turn(p_floats: PackedFloat32Array, p_limb: int) -> Quaternion:
	var at: int = p_limb * 4
	return Quaternion(p_floats[at], p_floats[at + 1], p_floats[at + 2], p_floats[at + 3])
