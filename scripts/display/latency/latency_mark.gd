class_name LatencyMark
extends RefCounted
## The times at which a sample passed each stage from the wearer's suit to a screen (thesis 7.4).
##
## All times are µs of one clock, the server's: who has another clock converts first. A time that
## nobody knows is [constant UNKNOWN]; the stages on both sides of it are then not counted.

## A time that is not known.
const UNKNOWN: int = -1
## What happens between two times, in order: one less than there are times.
const STAGES: Array[StringName] = [
	&"trainee", &"uplink", &"simulation", &"sending", &"downlink", &"display"
]
## Columns of a line for a file.
const COLUMNS: Array[String] = [
	"person",
	"sample",
	"tick",
	"sampled_usec",
	"sent_usec",
	"received_usec",
	"simulated_usec",
	"snapshot_sent_usec",
	"arrival_usec",
	"displayed_usec",
	"total_ms",
]

## Whose sample it is, the person's number.
var person: int = 0
## Number of the sample.
var sample: int = 0
## The server's tick that first moved by it.
var tick: int = 0
## When it was taken.
var sampled_usec: int = UNKNOWN
## When the trainee sent it.
var sent_usec: int = UNKNOWN
## When the server received it.
var received_usec: int = UNKNOWN
## When the step was done that moved by it.
var simulated_usec: int = UNKNOWN
## When the server sent the snapshot.
var snapshot_sent_usec: int = UNKNOWN
## When the snapshot arrived here.
var arrival_usec: int = UNKNOWN
## When the frame that shows it was drawn.
var displayed_usec: int = UNKNOWN


## All times, in the order of the stages.
func times() -> PackedInt64Array:
	return PackedInt64Array(
		[
			sampled_usec,
			sent_usec,
			received_usec,
			simulated_usec,
			snapshot_sent_usec,
			arrival_usec,
			displayed_usec,
		]
	)


## Duration of a stage of [constant STAGES], ms; NAN where it is not known.
func stage_ms(p_stage: int) -> float:
	var all: PackedInt64Array = times()
	return _between(all[p_stage], all[p_stage + 1])


## From the sample to the display, ms; NAN where it is not known.
func total_ms() -> float:
	return _between(sampled_usec, displayed_usec)


## The values of [constant COLUMNS]; what is not known is empty.
func to_line() -> PackedStringArray:
	var line: PackedStringArray = [str(person), str(sample), str(tick)]
	for time: int in times():
		line.append(str(time) if time != UNKNOWN else "")
	var total: float = total_ms()
	line.append("%.3f" % total if not is_nan(total) else "")
	return line


static func _between(p_first: int, p_second: int) -> float:
	if p_first == UNKNOWN or p_second == UNKNOWN:
		return NAN
	return (p_second - p_first) / 1000.0
