class_name OtherServerKey
extends RefCounted
## A server has shown another key than the one that it was to have: a new one, or it is another
## server.

## Address of the server, as of [method KnownServers.address].
var address: String = ""
## Fingerprint of the key that it was to have.
var known: String = ""
## The key that it has shown.
var shown: PackedByteArray = PackedByteArray()
## Where the known key stands, for people.
var source: String = ""
## Whether the user has named the fingerprint: then no other is taken.
var is_pinned: bool = false


## The fingerprint of the key that it has shown.
func fingerprint() -> String:
	return KeyFingerprint.of(shown)


## What is to be said where nobody can be asked.
func describe() -> String:
	if is_pinned:
		var pinned: String = "the server at %s shows the key %s, and %s was given"
		return pinned % [address, fingerprint(), known]
	var text: String = (
		"the server at %s shows another key than the last time: %s, and not %s (%s)."
		+ " It may have been set up anew, or somebody stands between."
		+ " Nothing was sent to it. If its staff confirm the new one, come once with --trust-new-key"
	)
	return text % [address, fingerprint(), known, source]
