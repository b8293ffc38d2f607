class_name TrafficMeter
extends RefCounted
## Counts the bytes that the transport sends and receives, with headers of ENet but not of UDP/IP.

## Bytes since the start.
var sent: int = 0
## Bytes since the start.
var received: int = 0

var _last_sent: int = 0
var _last_received: int = 0
var _since_usec: int = Time.get_ticks_usec()


## Takes over what the transport has counted, see [method ThreadedPeer.stats]. A new transport
## counts from 0 again.
func read(p_stats: Dictionary) -> void:
	var out: int = p_stats.get("sent_bytes", 0)
	var into: int = p_stats.get("received_bytes", 0)
	sent += out - _last_sent if out >= _last_sent else out
	received += into - _last_received if into >= _last_received else into
	_last_sent = out
	_last_received = into


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
