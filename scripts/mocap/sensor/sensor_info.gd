class_name SensorInfo
extends RefCounted
## What a feed knows about one sensor.

## What a sensor does.
enum State {
	## Found, but it does not measure yet.
	WAITING,
	## It measures, and its samples come.
	MEASURING,
	## It measured, but no sample came for a while.
	SILENT,
	## It reported a fault, see [member trouble].
	FAILED,
}

## Names of the states for people, by [enum State].
const STATE_NAMES: PackedStringArray = ["waiting", "measuring", "silent", "failed"]

## Its unique and lasting name: a device id such as "00300001", or for MVN the
## segment's name.
var id: String = ""
## Where it hangs, for people: "XM 00100123 / 3".
var where: String = ""
## The mount on the body that the device itself reports, one of [constant BodyMounts.NAMES], or
## empty.
var mount: StringName = &""
## What it does.
var state: State = State.WAITING
## What is wrong, for people, or an empty text.
var trouble: String = ""
## Recent samples per second; 0 if none came.
var rate_hz: float = 0.0
## Share of the samples that got lost, 0 to 1.
var loss: float = 0.0
## Time since the newest sample, s; infinite if there was none.
var age_s: float = INF
## How full the battery is, 0 to 1; -1 if that is not known.
var battery: float = -1.0


## A copy, for another thread.
func copy() -> SensorInfo:
	var other: SensorInfo = SensorInfo.new()
	other.id = id
	other.where = where
	other.mount = mount
	other.state = state
	other.trouble = trouble
	other.rate_hz = rate_hz
	other.loss = loss
	other.age_s = age_s
	other.battery = battery
	return other


## The state in a word.
func state_name() -> String:
	return STATE_NAMES[state]
