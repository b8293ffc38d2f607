class_name OrdersOptions
extends RefCounted
## What an instructor orders without typing (docs/session-guide.md).


## Their rows.
static func rows() -> Array[OptionRow]:
	return [
		(
			OptionRow
			. text(
				"orders",
				Roles.names(Roles.Capability.MODERATE),
				"orders to give, one after the other (docs/session-guide.md)"
			)
			. shown_as("ORDER:NAME,...")
		),
	]
