# SPDX-License-Identifier: MIT
extends Node
## Runs every check, prints "N passed, N failed" last, and exits with 0 or 1.


func _ready() -> void:
	var checks := Checks.new()
	checks.that("extension is loaded", ClassDB.class_exists("BindingsProbe"))
	if checks.failed == 0:
		await _run("res://scripts/values_checks.gd", checks)
		await _run("res://scripts/objects_checks.gd", checks)
	print("%d passed, %d failed" % [checks.passed, checks.failed])
	get_tree().quit(0 if checks.failed == 0 else 1)


# Loaded late, because these scripts don't parse without the extension's classes.
func _run(path: String, checks: Checks) -> void:
	var script: GDScript = load(path)
	var node: Node = script.new()
	add_child(node)
	await node.call("run", checks)
	node.free()
