class_name CommandTick
extends RefCounted
## Which tick of the server a command reaches: for whoever simulates ahead of the server's news.


## The tick, with its fraction, that a datagram reaches which leaves at a time of the stream's
## clock, s, and takes so long there and back, µs.
static func reached(p_replica: WorldReplica, p_now_s: float, p_round_trip_usec: int) -> float:
	var there_s: float = p_replica.smoother.server_time(p_now_s) + p_round_trip_usec / 1e6
	return there_s * p_replica.tick_rate()
