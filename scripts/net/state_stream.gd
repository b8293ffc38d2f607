@abstract class_name StateStream
extends RefCounted
## The source of a client's world: a server or a recording. The client does not know which.

## A message about the state of the world: a snapshot's datagram, a change of the entity table,
## events, a level. The time is that of [method now_s] at which it arrived. Not checked yet.
signal received(p_bytes: PackedByteArray, p_time_s: float)
## A connection begins: what was received before is void.
signal restarted
## A message for the user, or an empty text.
signal status_changed(p_text: String)
## The stream has ended for good: the exit code of the program, and why (empty: all went well).
signal ended(p_exit_code: int, p_why: String)

## Exit code: all went well.
const EXIT_DONE: int = 0
## Exit code: something failed.
const EXIT_FAILED: int = 1
## Exit code: wrong options.
const EXIT_OPTIONS: int = 2
## Exit code: the server refuses the client, or has a level that is not here.
const EXIT_REFUSED: int = 3
## Exit code: no server answers.
const EXIT_NO_SERVER: int = 4

## Bytes in and out; none for a recording.
var traffic: TrafficMeter = TrafficMeter.new()

## Begins. Returns why it cannot, or an empty text.
@abstract func open() -> String

## Processes what has arrived; the frame has this length, s.
@abstract func advance(p_delta_s: float) -> void

## The clock of [signal received], s.
@abstract func now_s() -> float

## The same clock at the time that a frame is for, µs of [method Time.get_ticks_usec].
@abstract func frame_s(p_frame_usec: int) -> float

## The server's clock at a local time (both µs), as far as it is known.
@abstract func server_usec(p_local_usec: int) -> int

## Whether the server's clock is known: whether delays can be measured.
@abstract func knows_server_clock() -> bool

## Number of the client's session; 0 where it has none.
@abstract func session() -> int

## Where it comes from, for people: the server's address, or the file.
@abstract func describe() -> String

## How the connection is protected, for the screen; empty where there is none.
@abstract func security() -> String

## Sends a datagram to the server, if there is one.
@abstract func send_fast(p_bytes: PackedByteArray) -> void

## Ends.
@abstract func close() -> void
