class_name LevelCheck
extends RefCounted
## Looks for what is wrong in a level: see [enum LevelFault.Kind].
##
## The level must be in the tree for two physics frames, so that the engine knows its bodies. It
## changes nothing in it.

## What was found, the worst first.
var faults: Array[LevelFault] = []

var _level: Level = null


func _init(p_level: Level) -> void:
	_level = p_level


## Does the work: up to a second or two for a town.
func run() -> void:
	var findings: LevelFindings = LevelFindings.new(_level)
	SpawnCheck.new(findings).run()
	BuildCheck.new(findings).run()
	FlickerCheck.new(findings).run()
	WalkCheck.new(findings).run()
	faults = findings.faults
	faults.sort_custom(func(a: LevelFault, b: LevelFault) -> bool: return a.severity > b.severity)


## How many are faults, not hints.
func count_faults() -> int:
	return (
		faults
		. filter(func(one: LevelFault) -> bool: return one.severity == LevelFault.Severity.FAULT)
		. size()
	)
