class_name TransportEvent
extends RefCounted
## Something that the transport's thread reports to the main thread.

## What happened.
enum Kind {
	## A connection is made; nothing is known about the other end yet.
	JOINED,
	## A connection is over; [member code] is a [DisconnectReason].
	GONE,
	## A packet for the multiplayer API.
	PACKET,
	## The other end goes on from another address, [member key].
	MOVED,
	## Somebody breaks the rules; for the log.
	TROUBLE,
	## The host had failed and was replaced; all connections are over.
	REOPENED,
	## The host cannot be made, or the client's connection to the server is over.
	FAILED,
}

## What happened.
var kind: Kind = Kind.TROUBLE
## The peer's id.
var peer: int = 0
## The packet.
var bytes: PackedByteArray = PackedByteArray()
## How the packet was sent.
var mode: MultiplayerPeer.TransferMode = MultiplayerPeer.TRANSFER_MODE_RELIABLE
## Transfer channel of the packet, as the multiplayer API counts.
var channel: int = 0
## Why a connection is over.
var code: int = 0
## Address of the other end, or what [member text] is filed under.
var key: String = ""
## For people.
var text: String = ""
## Of [constant Kind.JOINED]: what both ends of a sealed connection know, and nobody else; empty
## without sealing.
var exporter: PackedByteArray = PackedByteArray()
## Of [constant Kind.JOINED] on a server: the role that the sealed connection was made for.
var role: int = 0
## Of [constant Kind.JOINED] on a client: whether the role needs a password.
var locked: bool = false
## Of [constant Kind.JOINED] on a client: see [member TransportSealing.return_tag].
var return_tag: PackedByteArray = PackedByteArray()
## Of [constant Kind.JOINED] on a client: the public key that the server has proved; empty without
## sealing. Of [constant Kind.FAILED]: the one that was shown instead of
## [member TransportSealing.known_key], or nothing.
var server_key: PackedByteArray = PackedByteArray()
## Of [constant Kind.FAILED]: whether trying again is useless.
var final: bool = false


func _init(p_kind: Kind = Kind.TROUBLE, p_peer: int = 0) -> void:
	kind = p_kind
	peer = p_peer
