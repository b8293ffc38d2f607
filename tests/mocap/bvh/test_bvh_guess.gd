extends TestCase
## Unit, up axis and limbs of the motion files of many programs, written from our own clips, and
## what is no person.

const Files: GDScript = preload("foreign_files.gd")
const Schemes: GDScript = preload("foreign_schemes.gd")
const Animals: GDScript = preload("animal_samples.gd")

const AXES: Array[BvhOptions.UpAxis] = [
	BvhOptions.UpAxis.Y,
	BvhOptions.UpAxis.Z,
	BvhOptions.UpAxis.Y,
	BvhOptions.UpAxis.Z,
	BvhOptions.UpAxis.X,
	BvhOptions.UpAxis.Y_DOWN,
	BvhOptions.UpAxis.Z_DOWN,
	BvhOptions.UpAxis.X_DOWN,
]
## Of each scheme so many files.
const FILES: int = 8
## Least share of files whose limbs are all found.
const MAPPED: float = 0.98

# Made once, as reading our clips takes the longest.
var _motions: Array[Files.Motion] = []
var _random: RandomNumberGenerator = RandomNumberGenerator.new()


func before_each() -> void:
	_random.seed = 7
	if _motions.is_empty():
		_motions = [
			Files.motion("01_01", 900, 24, 4),
			Files.motion("01_03", 400, 24, 4),
			Files.motion("01_03", 2600, 24, 4),
			Files.motion("Boxing_Toes", 900, 24, 4),
		]


func test_unit_up_axis_and_limbs_of_many_files() -> void:
	var mapped: int = 0
	var files: int = 0
	for scheme: String in Schemes.SCHEMES:
		for number: int in FILES:
			var style: Files.Style = _style(scheme, number)
			var motion: Files.Motion = _motions[files % _motions.size()]
			var note: String = _describe(style)
			var clip: BvhClip = _read(motion, style)
			equal(clip.up_axis, style.axis, "%s: %s" % [note, clip.up_reason])
			almost_equal(clip.unit_metres, style.unit, style.unit * 1e-6, note)
			mapped += 1 if _is_mapped(clip, style) else 0
			_check_heights(clip, motion, style)
			files += 1
	is_true(files >= 200, "%d files" % files)
	var share: float = float(mapped) / files
	is_true(share >= MAPPED, "%.3f of %d files are mapped" % [share, files])


func test_people_who_lie_or_crawl() -> void:
	for tilt: float in [-90.0, 90.0, 80.0]:
		for axis: BvhOptions.UpAxis in [BvhOptions.UpAxis.Y, BvhOptions.UpAxis.Z]:
			for motion: Files.Motion in _motions:
				var style: Files.Style = Files.Style.new()
				style.axis = axis
				style.tilt_deg = tilt
				var clip: BvhClip = _read(motion, style)
				equal(clip.up_axis, axis, "%s %.0f deg: %s" % [axis, tilt, clip.up_reason])
				equal(clip.unit_metres, 0.01)


func test_people_who_lie_and_then_rise() -> void:
	for turn: Vector3 in [Vector3.LEFT, Vector3.RIGHT, Vector3.FORWARD, Vector3.BACK]:
		for axis: BvhOptions.UpAxis in [BvhOptions.UpAxis.Y, BvhOptions.UpAxis.Z]:
			for lying: float in [0.4, 0.7, 0.9]:
				var style: Files.Style = Files.Style.new()
				style.axis = axis
				var clip: BvhClip = _read(_rising(_motions[3], turn, lying), style)
				equal(clip.up_axis, axis, "%s, %s of it: %s" % [turn, lying, clip.up_reason])


func test_a_figure_with_short_legs_is_a_person() -> void:
	for legs: float in [0.35, 0.5]:
		for original: Files.Motion in _motions:
			var clip: BvhClip = _read(_short_legged(original, legs), Files.Style.new())
			var anatomy: BvhAnatomy = BvhAnatomy.new(clip, HumanoidMap.from_clip(clip))
			equal(anatomy.find_fault(), "")
			equal(clip.up_axis, BvhOptions.UpAxis.Y)
			equal(clip.unit_metres, 0.01, clip.unit_reason)


func test_people_of_no_size_are_scaled_to_an_adult() -> void:
	# Figures of 3.9 m in centimetres, of 0.6 m in metres, of 300 and 0.002 units.
	for unit: float in [0.0044, 2.8, 0.0058, 870.0]:
		var style: Files.Style = Files.Style.new()
		style.unit = unit
		var clip: BvhClip = _read(_motions[3], style)
		var anatomy: BvhAnatomy = BvhAnatomy.new(clip, HumanoidMap.from_clip(clip))
		almost_equal(anatomy.leg * clip.unit_metres, BvhGuess.USUAL_LEG, 1e-4)
		contains(clip.unit_reason, "scaled to 0.86 m")
		contains("\n".join(clip.notes), "no adult's size in any unit and was scaled")


func test_small_and_tall_people_keep_their_size() -> void:
	# The boxer's legs are 0.86 m long.
	for leg: float in [0.56, 0.7, 1.0, 1.08]:
		for unit: String in ["m", "cm", "mm"]:
			var style: Files.Style = Files.Style.new()
			style.unit = BvhOptions.UNITS[unit] * 0.8565 / leg
			var clip: BvhClip = _read(_motions[3], style)
			equal(clip.unit_metres, BvhOptions.UNITS[unit], "legs of %.2f m in %s" % [leg, unit])
			equal(clip.notes.size(), 0)


func test_a_far_static_joint_says_nothing() -> void:
	for axis: BvhOptions.UpAxis in [BvhOptions.UpAxis.Y, BvhOptions.UpAxis.Z]:
		for motion: Files.Motion in _motions:
			var style: Files.Style = Files.Style.new()
			style.scheme = "Bandai"
			style.is_below_static_joint = true
			style.axis = axis
			style.rest = "stretched"
			equal(_read(motion, style).up_axis, axis)


func test_what_is_no_person_is_refused() -> void:
	for animal: String in Animals.ANIMALS:
		for axis: BvhOptions.UpAxis in Files.TURNS:
			for unit: float in [1.0, 100.0, 17.7]:
				var source: BvhSource = BvhSource.new()
				var clip: BvhClip = Animals.make(animal, Files.TURNS[axis], unit)
				source.use(clip)
				is_true(source.error != "", "%s is taken for a person" % animal)
				contains(source.error, "animal.bvh: ")
				is_true(
					(
						source.error.contains("this is no person")
						or source.error.contains("no joint is")
					),
					source.error
				)


func test_a_person_with_no_motion() -> void:
	for axis: BvhOptions.UpAxis in Files.TURNS:
		var style: Files.Style = Files.Style.new()
		style.axis = axis
		var motion: Files.Motion = Files.Motion.new()
		motion.rest = _motions[3].rest
		var clip: BvhClip = _read(motion, style)
		equal(clip.frame_count, 0)
		equal(clip.up_axis, axis)
		equal(clip.unit_metres, 0.01)


## One of the ways to write a file; all are met over the numbers and schemes.
func _style(p_scheme: String, p_number: int) -> Files.Style:
	var style: Files.Style = Files.Style.new()
	style.scheme = p_scheme
	style.unit = BvhOptions.UNITS.values()[_random.randi() % BvhOptions.UNITS.size()]
	style.axis = AXES[p_number % AXES.size()]
	style.order = Files.ORDERS.keys()[_random.randi() % Files.ORDERS.size()]
	style.rest = ["same", "same", "root", "stretched"][_random.randi() % 4]
	style.rest_frames = [0, 0, 1, 5][_random.randi() % 4]
	style.is_below_static_joint = _random.randf() < 0.3
	return style


func _describe(p_style: Files.Style) -> String:
	var parts: Array = [
		p_style.scheme,
		BvhOptions.unit_name(p_style.unit),
		BvhOptions.axis_name(p_style.axis),
		p_style.order,
		p_style.rest,
		p_style.rest_frames,
		p_style.is_below_static_joint,
	]
	return "%s, %s, %s, %s, rest %s, %d frames of it, static joint %s" % parts


func _read(p_motion: Files.Motion, p_style: Files.Style) -> BvhClip:
	var result: BvhParser.Result = BvhParser.parse_text(Files.text(p_motion, p_style), "file.bvh")
	equal(result.error, "")
	return result.clip


## Whether all limbs are the right joints.
func _is_mapped(p_clip: BvhClip, p_style: Files.Style) -> bool:
	var map: HumanoidMap = HumanoidMap.from_clip(p_clip)
	if map.error != "":
		return false
	var names: Dictionary[String, String] = Schemes.names(p_style.scheme)
	for limb: int in Limbs.COUNT:
		if p_clip.joints[map.joints[limb]].name != names[String(Limbs.BONES[limb])]:
			return false
	return true


## The limbs are as high above and below the hips as they are in our clip.
func _check_heights(p_clip: BvhClip, p_motion: Files.Motion, p_style: Files.Style) -> void:
	var rig: BvhRig = BvhRig.from_clip(p_clip)
	equal(rig.error, "", _describe(p_style))
	if rig.error != "":
		return
	var frame: int = p_motion.hips.size() / 2
	var positions: PackedVector3Array = p_clip.sample_global(frame + p_style.rest_frames).positions
	var wanted: Dictionary[String, Vector3] = {"Hips": Vector3.ZERO}
	for key: String in Files.keys():
		if key != "Hips":
			var above: String = Files.parent(key)
			var offset: Vector3 = p_motion.rest[key] - p_motion.rest[above]
			wanted[key] = wanted[above] + p_motion.turns[frame][above] * offset
	for limb: int in Limbs.COUNT:
		var height: float = positions[rig.map.joints[limb]].y - positions[rig.map.joints[0]].y
		almost_equal(height, wanted[String(Limbs.BONES[limb])].y, 2e-3, _describe(p_style))


## Somebody who lies for a share of the motion, and then rises about an axis.
func _rising(p_motion: Files.Motion, p_axis: Vector3, p_lying: float) -> Files.Motion:
	var found: Files.Motion = Files.Motion.new()
	found.rest = p_motion.rest
	var count: int = p_motion.hips.size()
	for frame: int in count:
		var risen: float = maxf(float(frame) / (count - 1) - p_lying, 0.0) / (1.0 - p_lying)
		var tilt: Quaternion = Quaternion(p_axis, (1.0 - risen) * PI / 2.0)
		var turns: Dictionary[String, Quaternion] = {}
		for key: String in p_motion.turns[frame]:
			turns[key] = tilt * p_motion.turns[frame][key]
		found.turns.append(turns)
		found.hips.append(p_motion.hips[frame] * Vector3(1.0, 0.1 + 0.9 * risen, 1.0))
	return found


## The same motion of a figure with short legs and arms and a large head.
func _short_legged(p_motion: Files.Motion, p_legs: float) -> Files.Motion:
	var found: Files.Motion = Files.Motion.new()
	found.turns = p_motion.turns
	for key: String in Files.keys():
		var scale: float = 1.0
		if key.contains("Head"):
			scale = 2.5
		elif key.contains("Arm") or key.contains("Hand"):
			scale = p_legs * 1.2
		elif key.contains("Leg") or key.contains("Foot") or key.contains("Toes"):
			scale = p_legs
		var above: String = Files.parent(key)
		var offset: Vector3 = p_motion.rest[key] - p_motion.rest.get(above, Vector3.ZERO)
		found.rest[key] = found.rest.get(above, Vector3.ZERO) + scale * offset
	for hips: Vector3 in p_motion.hips:
		found.hips.append(hips * Vector3(p_legs, p_legs, p_legs))
	return found
