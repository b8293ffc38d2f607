class_name RecordedSuit
extends UsbSuitFeed
## The suits of a recording, as if they were plugged in.

## The recording.
var player: RawPlayer = null


## Hands out what [param p_player] plays; whoever owns that goes on with it.
func play(p_player: RawPlayer) -> void:
	player = p_player
	_hub.play(p_player)


## Nothing to close; the recording is just not played any longer.
func close() -> void:
	_hub.play(null)
	super()


func describe() -> String:
	return "%d recorded trackers" % list_sensors().size()
