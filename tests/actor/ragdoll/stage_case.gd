extends TestCase
## What tests with ragdolls have in common: a fresh [code]_stage[/code] and fast physics for each.

const Stage: GDScript = preload("stage.gd")
const FastPhysics: GDScript = preload("fast_physics.gd")

var _stage: Stage = null


func before_each() -> void:
	FastPhysics.start()
	_stage = Stage.new()
	add_child(_stage)


func after_each() -> void:
	FastPhysics.stop()
	_stage.free()


## Goes on with an empty stage at time 0.
func _clear_stage() -> void:
	_stage.free()
	_stage = Stage.new()
	add_child(_stage)
