class_name Bench
extends SceneTree
## Base of the benchmarks: reads and checks the options, measures, prints the report, ends.
##
## A benchmark is [code]tests/bench/bench_<name>.gd[/code]: its first [code]##[/code] line says what
## it measures, the others name its options; [code]./run bench[/code] prints them.

## The body that most people have.
const SOLDIER: String = "res://scenes/actor/soldier.tscn"

## The options that were given.
var arguments: BenchArguments = null
## Where values go.
var report: BenchReport = null


func _initialize() -> void:
	arguments = BenchArguments.parse(OS.get_cmdline_user_args(), options())
	_run.call_deferred()


## The options by their names, as [method BenchArguments.parse] takes them.
func options() -> Dictionary:
	return {}


## What is wrong with the options besides, or an empty text.
func find_fault() -> String:
	return ""


## Measures, and adds values to the report. May await.
func measure() -> void:
	pass


## The value of an option.
func option(p_name: String) -> Variant:
	return arguments.value(p_name)


## All values of an option that may be given more than once, or the default.
func values(p_name: String, p_default: Array) -> PackedStringArray:
	var given: PackedStringArray = arguments.list(p_name)
	return PackedStringArray(p_default) if given.is_empty() else given


## The root mode that --root names.
func root_mode() -> RagdollMotor.RootMode:
	return RootModes.BY_NAME[option("root")]


func _run() -> void:
	var fault: String = arguments.error if arguments.error != "" else find_fault()
	if fault != "":
		printerr(fault)
		quit(2)
		return
	var file: String = (get_script() as Script).resource_path.get_file()
	report = BenchReport.new(file.trim_prefix("bench_").get_basename(), option("json"))
	await measure()
	quit(report.finish())
