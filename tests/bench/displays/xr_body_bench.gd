extends Bench
## How well a body made of a headset and two hands resembles the recorded one that wore them, in
## simulated time; no limb but the head and the hands is measured.
##
## Options: --bvh=FILE (again for more; default: the clips of the repository), --seconds=30 of each,
## --rate=60 (samples a second).

const Scene: GDScript = preload("res://tests/mocap/xr/headset_scene.gd")

const _MAX_SLIDE_CM: float = 20.0
# A foot this near to the ground stands, m, if the hips are no higher than this above their height
# in standing and no lower than that part of it.
const _ON_GROUND_M: float = 0.03
const _IN_AIR: float = 0.03
const _ON_FEET: float = 0.5

var _slides: Statistics = Statistics.new()
var _beyond: int = 0
var _last: PackedVector3Array = [Vector3.INF, Vector3.INF]


func options() -> Dictionary:
	return {"bvh": "", "seconds": 30.0, "rate": 60.0}


func measure() -> void:
	for clip: String in BenchArguments.clips(arguments):
		var scene: Scene = Scene.new(clip)
		if scene.error() != "":
			report.leave_out(clip, scene.error())
			continue
		scene.rate = option("rate")
		_follow(scene, roundi(option("seconds") * scene.rate))
		_report("%s, headset and hands alone" % clip.get_file())


func _follow(p_scene: Scene, p_steps: int) -> void:
	_slides = Statistics.new()
	_beyond = 0
	_last.fill(Vector3.INF)
	var source: XrBodySource = XrBodySource.new(p_scene.size().height)
	var figure: BodySegments = BodySegments.new(p_scene.size())
	for _step: int in p_steps:
		p_scene.advance()
		source.push(p_scene.frame)
		var sample: PoseSample = source.sample(p_scene.now_usec())
		figure.solve(sample)
		_note_slides(figure, p_scene.rate)
		_beyond += _count_beyond(sample)


func _note_slides(p_figure: BodySegments, p_rate: float) -> void:
	# Who is in the air, or down on the floor, does not stand.
	var hips: float = p_figure.bases[0].y / p_figure.rest_base(0).y
	var is_up: bool = hips > _ON_FEET and hips < 1.0 + _IN_AIR
	for side: int in 2:
		var ball: Vector3 = p_figure.tails[Limbs.FEET[side]]
		var stands: bool = ball.y < _ON_GROUND_M and is_up
		if stands and _last[side].is_finite():
			var way: Vector3 = ball - _last[side]
			_slides.add(Vector2(way.x, way.z).length() * 100.0 * p_rate)
		_last[side] = ball if stands else Vector3.INF


## Joints beyond the range of people's.
static func _count_beyond(p_sample: PoseSample) -> int:
	var found: int = 0
	for mount: int in BodyMounts.COUNT:
		if not JointRange.knows(mount):
			continue
		var above: Quaternion = p_sample.orientation(BodyMounts.LIMBS[BodyMounts.PARENTS[mount]])
		var here: Quaternion = p_sample.orientation(BodyMounts.LIMBS[mount])
		found += 1 if JointRange.excess(mount, above, here) > 0.02 else 0
	return found


func _report(p_case: String) -> void:
	report.at_most(p_case, "joints beyond their range", _beyond, "", 0.0)
	if _slides.count() > 0:
		var slide: float = _slides.percentile(0.95)
		report.at_most(p_case, "standing feet slide, p95", slide, "cm/s", _MAX_SLIDE_CM)
