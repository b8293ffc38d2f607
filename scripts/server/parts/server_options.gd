class_name ServerOptions
extends RefCounted
## Whom a server admits, what it sends, and how it is looked after.


## Their rows.
static func rows() -> Array[OptionRow]:
	var server: PackedStringArray = [ProgramRoles.SERVER]
	return [
		(
			OptionRow
			. number(
				"max-clients",
				server,
				Protocol.DEFAULT_MAX_CLIENTS,
				# ENet's maximum, less those that are just arriving.
				[1, 4000],
				"maximum of clients"
			)
		),
		(
			OptionRow
			. number(
				"max-per-address",
				server,
				ServerRules.QUARTER,
				[ServerRules.QUARTER, 4000],
				"maximum of clients from one address; -1: a quarter of --max-clients, 4 at least; 0: any"
			)
		),
		OptionRow.text(
			"server-name",
			server,
			"what clients that look for servers see; by default the name of the machine",
			ServerAnnouncement.MAX_NAME
		),
		(
			OptionRow
			. flag(
				"discovery",
				[ProgramRoles.SERVER, ProgramRoles.START],
				"answer clients that look for servers; the start screen: look for them on networks"
			)
			. or_default(1)
		),
		OptionRow.file(
			"server-key",
			server,
			"file of the key by which clients know the server again; made if there is none"
		),
		OptionRow.text("instructor-password", server, "password of instructors, if theirs differs"),
		OptionRow.flag("waiting-room", server, "everybody waits until an instructor admits them"),
		OptionRow.file(
			"ban-file", server, "JSON list of banned addresses; new bans are added to it"
		),
		OptionRow.number(
			"bandwidth", server, 250, [1, 1000000], "limit for each client's snapshots", "kbit/s"
		),
		OptionRow.decimal(
			"pose-error",
			server,
			Protocol.POSE_ERROR_DEG,
			[EntityTableMessage.MIN_ERROR_DEG, EntityTableMessage.MAX_ERROR_DEG],
			"maximum error of limbs on the wire",
			"degrees"
		),
		OptionRow.number(
			"status-port",
			server,
			0,
			[0, 65535],
			"TCP port of the status on 127.0.0.1; 0: the number of --port"
		),
		(
			OptionRow
			. text("bind", server, "address of this machine that the port is open at; *: all")
			. or_default("*")
		),
		OptionRow.number(
			"end-with", server, 0, [0, 1 << 30], "end when the process of this number has; 0: none"
		),
	]
