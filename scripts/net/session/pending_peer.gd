class_name PendingPeer
extends RefCounted
## A connection that has not been admitted yet: see [Admission].

## Id of the connection.
var peer: int = 0
## IP address.
var address: String = ""
## What it counts as: see [method AddressNetwork.of] and [method AddressNetwork.site_of].
var network: String = ""
## The network of its site.
var site: String = ""
## Since when the server waits for what is due next, µs.
var since_usec: int = 0
## What its proof is about.
var challenge: PackedByteArray = PackedByteArray()
## Key of the proofs, which only this client and the server have; empty without sealing.
var key: PackedByteArray = PackedByteArray()
## The role that a sealed connection was made for.
var sealed_role: int = 0
## What it has asked for; null before it has.
var request: JoinRequest = null
## Its session, once it is admitted.
var session: Session = null
## The connection that the session had until now; 0 if none.
var replaced_peer: int = 0
## The lost session that ends to make room for this one, or null.
var displaced: Session = null
## Why it was refused.
var why: String = ""
## Whether trying later may help.
var later: bool = false
## Whether it waits, in [WaitingLine].
var waits: bool = false
## What it waits for.
var waits_for: JoinReply.Wait = JoinReply.Wait.INSTRUCTOR
## The position in the line that its last notice named, and what it waits for; 0: none.
var sent_position: int = 0
var sent_for: JoinReply.Wait = JoinReply.Wait.INSTRUCTOR
## Whether it was refused.
var refused: bool = false


func _init(p_peer: int, p_address: String, p_now_usec: int) -> void:
	peer = p_peer
	address = p_address
	network = AddressNetwork.of(p_address)
	site = AddressNetwork.site_of(p_address)
	since_usec = p_now_usec


## For an instructor; see [method ServerLink.roster].
func row() -> RosterRow:
	var made: RosterRow = RosterRow.new()
	made.peer = peer
	made.name = request.name
	made.role = request.role
	made.address = address
	if waits_for != JoinReply.Wait.INSTRUCTOR:
		made.state = RosterRow.State.QUEUED
	return made
