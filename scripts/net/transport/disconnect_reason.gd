class_name DisconnectReason
extends RefCounted
## Why a connection ended; ENet carries it in the data of its disconnect command.

enum {
	## None was given: the network failed or the other end has died. It may come back.
	LOST,
	## The client left.
	LEFT,
	## An instructor or the server dismissed the client.
	DISMISSED,
	## The server is being closed.
	CLOSED,
	## The client broke the rules of the [TransportGuard].
	THROWN_OUT,
	## The same client has another connection now.
	REPLACED,
}
