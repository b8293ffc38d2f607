class_name DisconnectReason
extends RefCounted
## Why a connection ended; ENet carries it in the data of its disconnect command.

enum {
	## Nobody said anything: the network failed or the other end has died. It may come back.
	LOST,
	## The client left.
	LEFT,
	## The server's owner sent the client away.
	DISMISSED,
	## The server is being closed.
	CLOSED,
	## The client broke the rules of the [TransportGuard].
	THROWN_OUT,
	## The same client has another connection now.
	REPLACED,
}
