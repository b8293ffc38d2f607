extends RefCounted
## A part of the benchmark of calibration: what all of them have. Each is a script of its own with
## [method measure]; bench_calibration.gd names it.

const Person: GDScript = preload("person.gd")

## The options of the benchmark.
var arguments: BenchArguments = null
## Where figures go.
var report: BenchReport = null


## Measures and adds figures to the report.
func measure() -> void:
	pass


## The numbers of an option such as [code]--norths=0,10,20[/code].
func numbers(p_option: String) -> PackedFloat64Array:
	return PackedFloat64Array(Array(arguments.value(p_option).split_floats(",", false)))


## A generator for a round of this part: the same for the same seed, whatever other parts draw.
func generator(p_round: int) -> RandomNumberGenerator:
	var random: RandomNumberGenerator = RandomNumberGenerator.new()
	random.seed = hash([arguments.value("seed"), p_round])
	return random


## Full calibrations of wearers whose norths are spread by so many degrees, evenly or normally: the
## mean error of each one's limbs, degrees. [param p_hold] may change a wearer before.
func calibrate_fully(
	p_norths_deg: float, p_normal: bool, p_hold: Callable = Callable()
) -> Statistics:
	var poses: Array[PoseSample] = Person.clip_poses("01_01.bvh", 0.5, 6)
	var left: Statistics = Statistics.new()
	for number: int in arguments.value("rounds"):
		var person: Person = Person.new()
		person.random = generator(number)
		person.dress(PackedInt32Array(range(BodyMounts.COUNT)), p_norths_deg, p_normal)
		person.feed.soft_tissue_deg = arguments.value("soft")
		if p_hold.is_valid():
			p_hold.call(person)
		person.move_badly(arguments.value("efforts"))
		var result: CalibrationResult = person.calibrate(CalibrationGuide.Kind.FULL)
		left.add(Person.mean(person.errors_deg(result.calibration, poses)))
	return left
