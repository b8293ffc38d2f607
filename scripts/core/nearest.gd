class_name Nearest
extends RefCounted
## Suggests the name that a user may have meant who mistyped one.

## Longer words are not compared: nobody mistypes them, and the time grows with the square.
const MAX_LENGTH: int = 64


## A question to put behind a complaint, such as ": did you mean --person?"; or an empty text.
static func suggest(p_word: String, p_known: PackedStringArray, p_prefix: String = "") -> String:
	var found: String = find(p_word, p_known)
	return ": did you mean %s%s?" % [p_prefix, found] if found != "" else ""


## The known name that is nearest to a word, if one is near enough: up to a third of its letters may
## be wrong, missing, too many or exchanged with their neighbours. Otherwise an empty text.
static func find(p_word: String, p_known: PackedStringArray) -> String:
	var word: String = p_word.to_lower()
	if word == "" or word.length() > MAX_LENGTH:
		return ""
	var best: String = ""
	var least: int = 1 + maxi(1, word.length() / 3)
	for name: String in p_known:
		var distance: int = count_edits(word, name.to_lower().left(MAX_LENGTH))
		if distance < least:
			least = distance
			best = name
	return best


## How many letters have to be changed, added, removed or exchanged with their neighbour to make one
## word of another.
static func count_edits(p_from: String, p_to: String) -> int:
	var width: int = p_to.length() + 1
	var before: PackedInt32Array = []
	var last: PackedInt32Array = range(width)
	for i: int in p_from.length():
		var row: PackedInt32Array = [i + 1]
		for j: int in p_to.length():
			var matches: bool = p_from[i] == p_to[j]
			var edits: int = mini(last[j] + int(not matches), mini(last[j + 1], row[j]) + 1)
			var is_exchanged: bool = (
				i > 0 and j > 0 and p_from[i] == p_to[j - 1] and p_from[i - 1] == p_to[j]
			)
			row.append(mini(edits, before[j - 1] + 1) if is_exchanged else edits)
		before = last
		last = row
	return last[width - 1]
