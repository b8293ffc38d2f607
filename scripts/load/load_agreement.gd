class_name LoadAgreement
extends RefCounted
## Compares what clients have received: every client gets the same pose of a person in a tick as all
## others, whatever was lost in transit.

## Ticks that are remembered.
const KEPT: int = 256
## One of this many of a person's poses is compared.
const EVERY: int = 8

## Poses that two or more clients have reported.
var compared: int = 0
## Those of them that were not the same.
var different: int = 0

var _ticks: Array[int] = []
var _fingerprints: Array[Dictionary] = []


func _init() -> void:
	_ticks.resize(KEPT)
	_ticks.fill(-1)
	_fingerprints.resize(KEPT)


## Whether this pose is one of those that are compared.
func wants(p_tick: int, p_person: int) -> bool:
	return (p_tick + p_person) % EVERY == 0


## Takes a pose's fingerprint, of a person at a tick.
func take(p_tick: int, p_person: int, p_fingerprint: int) -> void:
	var index: int = p_tick % KEPT
	if _ticks[index] > p_tick:
		return
	if _ticks[index] != p_tick:
		_ticks[index] = p_tick
		_fingerprints[index] = {}
	if not _fingerprints[index].has(p_person):
		_fingerprints[index][p_person] = p_fingerprint
		return
	compared += 1
	if _fingerprints[index][p_person] != p_fingerprint:
		different += 1


## Counts anew.
func restart() -> void:
	compared = 0
	different = 0
