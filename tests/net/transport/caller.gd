extends Node
## Remote calls of every mode, for the test of the threaded peer.

## What was told.
var heard: Array[String] = []

@rpc("any_peer", "reliable")
func ask(p_text: String) -> void:
	tell.rpc_id(multiplayer.get_remote_sender_id(), p_text + " back")


@rpc("authority", "reliable")
func tell(p_text: String) -> void:
	heard.append(p_text)


@rpc("authority", "unreliable")
func tell_unreliably(p_text: String) -> void:
	heard.append(p_text)


@rpc("authority", "unreliable_ordered")
func tell_in_order(p_text: String) -> void:
	heard.append(p_text)


@rpc("authority", "call_remote", "reliable", 3)
func tell_aside(p_text: String) -> void:
	heard.append(p_text)
