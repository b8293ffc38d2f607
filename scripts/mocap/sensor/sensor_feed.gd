class_name SensorFeed
extends RefCounted
## Where the samples of one person's sensors come from: a suit, MVN's trackers, a recording.
## Feeds derive from it.
##
## Any thread may call it: [SuitSource] takes the frames in the sampling thread while a panel lists
## the sensors in the main one. A sensor keeps its index in the list while the feed lives; new ones
## are appended.

## Why nothing comes, or an empty text.
var error: String = ""
## Grows whenever the list of sensors changes.
var revision: int = 0


## The sensors and their state; the caller may keep and change the result.
func list_sensors() -> Array[SensorInfo]:
	return []


## The frames since the last call, oldest first.
func take_frames() -> Array[SensorFrame]:
	return []


## One line for people: what the feed is.
func describe() -> String:
	return "no sensors"
