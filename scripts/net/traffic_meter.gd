class_name TrafficMeter
extends RefCounted
## Counts the bytes that an ENet host sends and receives, with headers of ENet but not of UDP/IP.

## Bytes since the start.
var sent: int = 0
## Bytes since the start.
var received: int = 0

var _since_usec: int = Time.get_ticks_usec()


## Adds what the host has counted since the last call.
func read(p_host: ENetConnection) -> void:
	if p_host != null:
		sent += int(p_host.pop_statistic(ENetConnection.HOST_TOTAL_SENT_DATA))
		received += int(p_host.pop_statistic(ENetConnection.HOST_TOTAL_RECEIVED_DATA))


## Mean bytes per second sent since the start or [method restart].
func sent_per_second() -> float:
	return sent / _seconds()


## Mean bytes per second received since the start or [method restart].
func received_per_second() -> float:
	return received / _seconds()


## Starts counting anew.
func restart() -> void:
	sent = 0
	received = 0
	_since_usec = Time.get_ticks_usec()


func _seconds() -> float:
	return maxf((Time.get_ticks_usec() - _since_usec) / 1e6, 0.001)
