class_name StreamReader
extends RefCounted
## Reads the datagrams of one protocol. Each protocol derives from it.
##
## Whatever bytes come, nothing but a sentence may follow: readers check every length and number
## before they use it. One thread alone uses a reader.

## Why the last datagram could not be used, as a sentence for people; empty if it could.
var fault: String = ""
## When that came which is read now, µs of Unix time.
var now_usec: int = 0


## What the protocol is called, for people.
func title() -> String:
	return "nothing"


## The poses in a datagram (of TCP: in a piece of the stream) of a sender, oldest first.
func read(_p_bytes: PackedByteArray, _p_sender: String) -> Array[StreamSample]:
	return []


## What is to be sent now, at a time in µs of Unix time: requests and signs of life.
func talk(_p_now_usec: int) -> Array[StreamPort.Parcel]:
	return []


## What else is known of a sender, for the panel: serials of its devices, versions.
func detail(_p_sender: String) -> String:
	return ""


## What is wrong with a sender though its datagrams can be read, for people; mostly empty.
func trouble(_p_sender: String) -> String:
	return ""


## Where the stream comes from, for people, if that is no port that others send to.
func place() -> String:
	return ""


## What keeps the stream from coming at all, for people; mostly empty. In the main thread.
func obstacle() -> String:
	return ""


## Lets go of what it has opened. In the main thread.
func close() -> void:
	pass


## Refuses the datagram: says why.
func refuse(p_why: String) -> Array[StreamSample]:
	fault = p_why
	return []
