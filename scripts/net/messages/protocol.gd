class_name Protocol
extends RefCounted
## What both ends of a connection must agree on. See [code]docs/protocol.md[/code].

## First byte of every packet.
enum Message {
	## Server to client, fast path: a snapshot with the whole tick, see docs/protocol.md.
	KEY = 0,
	## Trainee to server, fast path: what its people do, see [SampleWriter]. Most of them begin with
	## [constant BASED_MOTION] or above instead.
	MOTION = 1,
	## Server to client, fast path: where bodies are, see [SnapshotDecoder].
	SNAPSHOT = 2,
	## Server to client, reliable: which entities there are, see [EntityTableMessage]. In parts.
	TABLE = 3,
	## A part of a packet that is too large for a datagram, see [MessageParts].
	PART = 4,
	## Client to server, fast path: which snapshots have arrived.
	ACK = 5,
	## Both ways, fast path: see [ClockMessage].
	CLOCK = 6,
	## Server to client, reliable: what the session has to say, see [enum Notice].
	CONTROL = 7,
	## Client to server, fast path: its stats, see [StatsMessage].
	STATS = 8,
	## Trainee to server, reliable: whose motion it sends, see [PeopleMessage].
	PEOPLE = 9,
	## Server to client, fast path: a snapshot of one person and nothing else.
	SNAPSHOT_OF_ONE = 10,
	## Client to server, fast path: see [CommandMessage].
	COMMAND = 11,
	## Server to client, either way: see [EventMessage].
	EVENTS = 12,
	## Server to client, reliable: see [LevelMessage]. In parts.
	LEVEL = 13,
	## Instructor to server, reliable: see [OrderMessage].
	ORDER = 14,
	## Server to instructor, reliable: see [AnswerMessage]. In parts.
	ANSWER = 15,
	## Server to instructor, reliable: see [RosterMessage]. In parts.
	ROSTER = 16,
	## Trainee to server, reliable: see [WearerMessage].
	WEARER = 17,
	## Client to server, reliable: it leaves for good; behind it the session's token, so that nobody
	## else can say so.
	LEAVE = 18,
	## Both ways, reliable or fast path: see [CallMessage].
	CALL = 19,
	## Server to client, reliable: see [RefusalMessage]. In parts.
	REFUSAL = 20,
	## Client to server, reliable: see [LevelRequestMessage].
	LEVEL_REQUEST = 21,
	## Server to client, reliable: see [LevelDataMessage].
	LEVEL_DATA = 22,
	## Server to client, and instructor to server, reliable: see [EffectMessage].
	EFFECT = 23,
	## Server to client, fast path: see [ImpactMessage].
	IMPACTS = 24,
	## Server to a client that walks, reliable: see [WalkMessage].
	WALK = 25,
	## Trainee to server, and back what became of it, reliable: see [MotionSetMessage].
	MOTION_SET = 26,
}

## Second byte of a [constant Message.CONTROL].
enum Notice {
	## The client must leave and not come back; a text says why.
	DISMISSED,
	## An instructor asks for a calibration: u8 which of the client's people, u8 which calibration,
	## u16 number for the answer, a [WearerMessage].
	CALIBRATE,
	## Something that the client's user is to know; a text.
	TELL,
}

## A first byte of this or above is [constant Message.MOTION] too: it holds a part of its number.
const BASED_MOTION: int = 128
## Raised with every change of what is sent; a server refuses other versions.
const VERSION: int = 9
## First bytes of a challenge and of a join request.
const HELLO: String = "DSMT"
## UDP port of a server by default.
const DEFAULT_PORT: int = 7777
## Largest payload of a datagram, bytes: it passes every usual network in one piece.
const MAX_DATAGRAM: int = 1200
## Maximum error of a limb's orientation on the wire, degrees.
const POSE_ERROR_DEG: float = 0.1
## The same from a trainee to the server.
const MOTION_ERROR_DEG: float = 0.1
## People and watchers that a server admits by default.
const DEFAULT_MAX_CLIENTS: int = 32
## Longest name of a person, characters.
const MAX_NAME: int = 32
## Bytes of a level's fingerprint.
const FINGERPRINT_SIZE: int = 8
## Longest name of a level, characters.
const MAX_LEVEL_NAME: int = 64
## The messages that are snapshots.
const SNAPSHOTS: Array[int] = [Message.KEY, Message.SNAPSHOT, Message.SNAPSHOT_OF_ONE]


## Which [enum Message] a packet is, by its first byte; -1 for an empty one.
static func kind_of(p_bytes: PackedByteArray) -> int:
	if p_bytes.is_empty():
		return -1
	return p_bytes[0] if p_bytes[0] < BASED_MOTION else Message.MOTION
