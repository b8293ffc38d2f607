class_name ConnectionOptions
extends RefCounted
## How a client finds its server, and how they know one another.


## Their rows.
static func rows() -> Array[OptionRow]:
	var joining: PackedStringArray = ProgramRoles.joining()
	var both: PackedStringArray = PackedStringArray([ProgramRoles.SERVER]) + joining
	var clients: PackedStringArray = Roles.names()
	var hosting: PackedStringArray = both + PackedStringArray([ProgramRoles.START])
	return [
		OptionRow.number(
			"port",
			hosting,
			Protocol.DEFAULT_PORT,
			[1, 65535],
			"UDP port of the server; of the start screen: where sessions are hosted, if it is free"
		),
		OptionRow.text("host", joining, "address of the server").or_default("127.0.0.1"),
		OptionRow.text(
			"name",
			clients,
			"your name, shown to the others; by default the role's",
			Protocol.MAX_NAME
		),
		OptionRow.text(
			"password",
			both,
			(
				"password of the session: the server asks for it, clients prove it."
				+ " Prefer DISMOUNT_PASSWORD: others on the machine can see arguments"
			)
		),
		(
			OptionRow
			. flag(
				"sealing",
				both,
				"encrypt and authenticate every datagram; 0 only where the network can be trusted"
			)
			. or_default(1)
		),
		(
			OptionRow
			. text(
				"server-fingerprint",
				joining,
				"fingerprint that the server's key must have; by default as the last time"
			)
			. shown_as("SHA256:...")
		),
		OptionRow.flag(
			"trust-new-key",
			joining,
			"trust the server's key though it is another than the last time, and remember it"
		),
		OptionRow.number(
			"snapshot-rate",
			joining,
			0,
			[0, 240],
			"snapshots per second to ask for; 0: one each tick"
		),
		OptionRow.decimal(
			"connect-timeout",
			clients,
			0.0,
			[0.0, 86400.0],
			"give up after this time without a server; 0: never",
			"s"
		),
		OptionRow.number(
			"protocol",
			clients,
			Protocol.VERSION,
			[0, 65535],
			"protocol version to claim, for tests"
		),
	]
