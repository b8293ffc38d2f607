extends Bench
## How well the body of a suit fits the headset of its wearer, in simulated time: the truth is a
## clip, the suit drifts, is noisy and has limbs of wrong lengths, the headset sits askew.
##
## Options: --bvh=FILE (again for more; default: the clips of the repository), --seed=1,
## --drift=3 (deg/min), --minutes=10, --injected=30 (deg), --rate=60 (samples a second),
## --noise=0.5 (deg of each limb), --size=0.97 (limbs of the suit by the true ones).

const Scene: GDScript = preload("res://tests/mocap/xr/headset_scene.gd")

const _MAX_OFF_DEG: float = 2.0
const _MAX_GAP_CM: float = 5.0
const _MAX_RATE_DEG: float = 5.0
const _STANDING_S: float = 60.0
const _COST_CALLS: int = 4000


func options() -> Dictionary:
	return {
		"bvh": "",
		"seed": 1,
		"drift": 3.0,
		"minutes": 10.0,
		"injected": 30.0,
		"rate": [60.0, 10.0, 1000.0],
		"noise": 0.5,
		"size": [0.97, 0.8, 1.25]
	}


func measure() -> void:
	for clip: String in BenchArguments.clips(arguments):
		var scene: Scene = Scene.new(clip, option("seed"))
		if scene.error() != "":
			report.leave_out(clip, scene.error())
			continue
		_stand(_worn(scene), clip.get_file(), option("injected"))
		_drift(_worn(Scene.new(clip, option("seed"))), clip.get_file())
	_time()


## A suit and a headset as people wear them.
func _worn(p_scene: Scene) -> Scene:
	p_scene.rate = option("rate")
	p_scene.noise = deg_to_rad(option("noise"))
	p_scene.length_ratio = option("size")
	p_scene.mount = Quaternion.from_euler(Vector3(0.05, 0.01, 0.02))
	p_scene.lever = HeadMount.USUAL_LEVER + Vector3(0.0, -0.01, 0.01)
	return p_scene


func _stand(p_scene: Scene, p_clip: String, p_injected: float) -> void:
	var fusion: HeadFusion = HeadFusion.new(p_scene.size())
	p_scene.pace = 0.0
	var fastest: float = 0.0
	var moved: float = 0.0
	var last: float = NAN
	for step: int in roundi((2.0 + _STANDING_S) * p_scene.rate):
		if step == roundi(2.0 * p_scene.rate):
			p_scene.heading = deg_to_rad(p_injected)
		p_scene.advance()
		var view: Transform3D = p_scene.frame.head
		fusion.apply(p_scene.suit, p_scene.frame)
		moved = maxf(moved, (p_scene.frame.head.origin - view.origin).length())
		if is_finite(last):
			var turn: float = absf(angle_difference(last, fusion.correction()))
			fastest = maxf(fastest, rad_to_deg(turn) * p_scene.rate)
		last = fusion.correction()
	var case: String = "%s, standing, %.0f deg injected" % [p_clip, p_injected]
	# The noise of the suit's own hips is no error of the heading.
	var off: float = absf(rad_to_deg(angle_difference(-p_scene.heading, fusion.correction())))
	report.at_most(case, "body off after 60 s", off, "deg", _MAX_OFF_DEG)
	report.at_most(case, "view moved", moved, "m", 0.0)
	report.at_most(case, "fastest turn of the body", fastest, "deg/s", 0.51)


func _drift(p_scene: Scene, p_clip: String) -> void:
	p_scene.drift = deg_to_rad(option("drift")) / 60.0
	var fusion: HeadFusion = HeadFusion.new(p_scene.size())
	var seen: BodySegments = BodySegments.new(p_scene.size())
	var off: Statistics = Statistics.new()
	var gap: Statistics = Statistics.new()
	var fastest: float = 0.0
	var last: float = NAN
	for step: int in roundi(option("minutes") * 60.0 * p_scene.rate):
		p_scene.advance()
		fusion.apply(p_scene.suit, p_scene.frame)
		var wanted: float = -p_scene.drift * p_scene.time_s
		off.add(absf(rad_to_deg(angle_difference(wanted, fusion.correction()))))
		if is_finite(last):
			var turn: float = absf(angle_difference(last, fusion.correction()))
			fastest = maxf(fastest, rad_to_deg(turn) * p_scene.rate)
		last = fusion.correction()
		seen.solve(p_scene.suit)
		if step > p_scene.rate:
			for hand: int in [Limbs.LEFT_HAND, Limbs.RIGHT_HAND]:
				gap.add(seen.bases[hand].distance_to(p_scene.figure.bases[hand]) * 100.0)
	var case: String = "%s, %.0f min at %.0f deg/min"
	case %= [p_clip, option("minutes"), option("drift")]
	report.at_most(case, "body off, worst", off.percentile(1.0), "deg", _MAX_OFF_DEG)
	report.add(case, "hand to controller, p99", gap.percentile(0.99), "cm")
	report.at_most(case, "hand to controller, worst", gap.percentile(1.0), "cm", _MAX_GAP_CM)
	report.at_most(case, "fastest turn of the body", fastest, "deg/s", _MAX_RATE_DEG + 0.01)


func _time() -> void:
	var clips: PackedStringArray = BenchArguments.clips(arguments)
	var scene: Scene = Scene.new(clips[0], option("seed"))
	if scene.error() != "":
		return
	scene.heading = 0.3
	var fusion: HeadFusion = HeadFusion.new(scene.size())
	fusion.finds_mount = false
	var costs: Statistics = Statistics.new()
	for _call: int in _COST_CALLS:
		scene.advance()
		var begin: int = Time.get_ticks_usec()
		fusion.apply(scene.suit, scene.frame)
		costs.add(Time.get_ticks_usec() - begin)
	report.add("a sample", "cost of the fusion, p50", costs.percentile(0.5), "us")
