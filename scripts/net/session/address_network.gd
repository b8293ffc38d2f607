class_name AddressNetwork
extends RefCounted
## The network that an address counts as where something is limited by address: a subscriber with
## one IPv6 address has its whole /64, and often a /48.

## Groups of 16 bits of an IPv6 address.
const _GROUPS: int = 8


## The network of one subscriber: an IPv4 address, or the /64 of an IPv6 one.
static func of(p_address: String) -> String:
	return _prefix(p_address, 4, 4)


## The network around it, of which one may have all: the /24 of an IPv4 address, the /48 of an IPv6
## one.
static func around(p_address: String) -> String:
	return _prefix(p_address, 3, 3)


## Where a site's machines have one network each, that of the site: an IPv4 address, as the machines
## of a lab are often in one /24, or the /48 of an IPv6 one.
static func site_of(p_address: String) -> String:
	return _prefix(p_address, 4, 3)


## The first bytes of an IPv4 address, or groups of an IPv6 one, as a key; what is no address is its
## own network.
static func _prefix(p_address: String, p_bytes: int, p_groups: int) -> String:
	# A link may have a dot in its name.
	var address: String = p_address.get_slice("%", 0)
	if address.contains("."):
		# "::ffff:192.0.2.1" is 192.0.2.1.
		var bytes: PackedStringArray = (
			address.get_slice(":", address.get_slice_count(":") - 1).split(".")
		)
		return ".".join(bytes.slice(0, p_bytes))
	var groups: PackedInt32Array = _groups_of(p_address)
	if groups.size() != _GROUPS:
		return p_address
	if groups.slice(0, 5) == PackedInt32Array([0, 0, 0, 0, 0]) and groups[5] == 0xFFFF:
		var bytes: PackedStringArray = []
		for group: int in groups.slice(6):
			bytes.append(str(group >> 8))
			bytes.append(str(group & 0xFF))
		return ".".join(bytes.slice(0, p_bytes))
	var prefix: PackedStringArray = []
	for group: int in groups.slice(0, p_groups):
		prefix.append("%x" % group)
	return ":".join(prefix) + "::"


## The groups of an IPv6 address, in full or with "::"; others than eight if it is none.
static func _groups_of(p_address: String) -> PackedInt32Array:
	var halves: PackedStringArray = p_address.get_slice("%", 0).split("::")
	var groups: PackedInt32Array = _read(halves[0])
	if halves.size() == 2:
		var last: PackedInt32Array = _read(halves[1])
		var between: PackedInt32Array = []
		between.resize(maxi(_GROUPS - groups.size() - last.size(), 0))
		groups.append_array(between)
		groups.append_array(last)
	return groups


static func _read(p_text: String) -> PackedInt32Array:
	var groups: PackedInt32Array = []
	for part: String in p_text.split(":", false):
		if not part.is_valid_hex_number() or part.length() > 4:
			return []
		groups.append(part.hex_to_int())
	return groups
