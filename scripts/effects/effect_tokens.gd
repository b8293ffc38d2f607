@tool
class_name EffectTokens
extends RefCounted
## The words and signs of an effect's code, without comments, each with where it stands.

## Code beyond this is not looked at: [member too_many] is true.
const MAX_TOKENS: int = 3000

## Tokens that say how code is built; the others are only counted.
const MARKS: Dictionary[String, bool] = {
	"(": true,
	")": true,
	"[": true,
	"]": true,
	"{": true,
	"}": true,
	";": true,
	"#": true,
	"@": true,
	"for": true,
	"while": true,
	"do": true,
	"else": true,
	"const": true,
	"struct": true,
	"out": true,
	"inout": true,
}

const _COMMENT: String = "//[^\\n]*|/\\*[\\s\\S]*?(?:\\*/|$)"
const _TOKEN: String = (
	"[A-Za-z_]\\w*|\\d[\\w.]*|\\.\\d\\w*|<<=|>>=|\\+\\+|--|<<|>>|&&|\\|\\|"
	+ "|[<>=!+\\-*/%&|^]=|\\S"
)

static var _comments: RegEx = RegEx.create_from_string(_COMMENT)
static var _tokens: RegEx = RegEx.create_from_string(_TOKEN)

var words: PackedStringArray = []
## Indices of those of [constant MARKS].
var marks: PackedInt32Array = []
var too_many: bool = false
## The text with comments blanked out: every character keeps its place.
var bare: String = ""

var _found: Array[RegExMatch] = []
## The index of the bracket that closes each one that is closed.
var _closing: Dictionary[int, int] = {}


func _init(p_text: String) -> void:
	bare = _without_comments(p_text)
	_found = _tokens.search_all(bare)
	too_many = _found.size() > MAX_TOKENS
	if too_many:
		_found.resize(MAX_TOKENS)
	for found: RegExMatch in _found:
		var word: String = found.get_string()
		if MARKS.has(word):
			marks.append(words.size())
		words.append(word)
	_pair_brackets()


func size() -> int:
	return words.size()


## The token at an index, or an empty text beyond the ends.
func at(p_index: int) -> String:
	return words[p_index] if p_index >= 0 and p_index < words.size() else ""


## The line of a token, from 1.
func line(p_index: int) -> int:
	if p_index < 0 or p_index >= _found.size():
		return 1
	return bare.left(_found[p_index].get_start()).count("\n") + 1


## The index of the bracket that closes the one at [param p_open]; -1 if none does.
func closing(p_open: int) -> int:
	return _closing.get(p_open, -1)


## Whether a token is a name or a keyword.
func is_word(p_index: int) -> bool:
	var token: String = at(p_index)
	return token != "" and token.is_valid_ascii_identifier()


## All in one pass: a text of nothing but brackets must not be searched for each of them.
func _pair_brackets() -> void:
	var open: PackedInt32Array = []
	for i: int in marks:
		match words[i]:
			"(", "[", "{":
				open.append(i)
			")", "]", "}":
				if not open.is_empty():
					_closing[open[-1]] = i
					open.remove_at(open.size() - 1)


static func _without_comments(p_text: String) -> String:
	var parts: PackedStringArray = []
	var from: int = 0
	for found: RegExMatch in _comments.search_all(p_text):
		parts.append(p_text.substr(from, found.get_start() - from))
		var lines: PackedStringArray = found.get_string().split("\n")
		for i: int in lines.size():
			lines[i] = " ".repeat(lines[i].length())
		parts.append("\n".join(lines))
		from = found.get_end()
	parts.append(p_text.substr(from))
	return "".join(parts)
