class_name LevelReference
extends RefCounted
## How a level is named between server and client: [code]NAME[/code] for one that is part of the
## program, [code]NAME@HASH[/code] for one that the server offers; see [method
## LevelManifest.content_hash].

## Name of the level.
var name: String = ""
## Its hash, 64 hexadecimal digits; empty if it is part of the program.
var content_hash: String = ""


## A reference from the text that was sent; a name that is none stays as it is.
static func parse(p_text: String) -> LevelReference:
	var reference: LevelReference = LevelReference.new()
	reference.name = p_text
	var at: int = p_text.rfind("@")
	if at > 0 and LevelManifest.is_hash(p_text.substr(at + 1)):
		reference.name = p_text.left(at)
		reference.content_hash = p_text.substr(at + 1)
	return reference


## The text for a level of a name and a hash.
static func text_of(p_name: String, p_hash: String) -> String:
	return p_name if p_hash == "" else "%s@%s" % [p_name, p_hash]
