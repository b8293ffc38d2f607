class_name TransportCallbacks
extends RefCounted
## What the thread of an ENet host calls, without waiting for the main thread. Each may be left out.

## Answers fast datagrams of the kind [member instant_kind]:
## [code]func(bytes: PackedByteArray, arrival_usec: int) -> PackedByteArray[/code].
var instant: Callable = Callable()
## First byte of what [member instant] answers.
var instant_kind: int = -1
## Sees every other fast datagram before the main thread gets it:
## [code]func(bytes: PackedByteArray) -> void[/code].
var watcher: Callable = Callable()
## On a client: makes what is sent to the server again and again:
## [code]func() -> PackedByteArray[/code].
var beacon: Callable = Callable()
## When [member beacon] is due again, from how often it was: [code]func(count: int) -> int[/code],
## µs.
var beacon_period: Callable = Callable()
