extends RefCounted
## A part of the benchmark of calibration: what all of them have. Each is a script of its own with
## [method measure]; bench_calibration.gd names it.

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
