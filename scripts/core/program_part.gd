@abstract class_name ProgramPart
extends Node
## One job of a program, such as the sound of a client or the levels of a server: see [PartList].

## Exit code of the program if [method begin] has a fault.
var fault_code: int = 1


## All parts are open: begins with files, devices, ports and connections. Returns why it cannot, or
## an empty text.
func begin() -> String:
	return ""


## Stats for the report of the program, by topic.
func report() -> Dictionary:
	return {}


## The program ends; waits until nothing of the part runs any more. It may be a coroutine.
func finish() -> void:
	pass


## Closes what the part has open. What it has not opened yet is none of it: opening may have failed
## half-way.
func close() -> void:
	pass
