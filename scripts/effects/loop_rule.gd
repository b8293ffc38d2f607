@tool
class_name LoopRule
extends RefCounted
## Lets only those loops through whose end is certain: an endless one hangs the graphics driver.
##
## A loop reads [code]for (int i = 0; i < 8; i++) { }[/code] with numbers, and nothing else changes
## its counter. The rounds of all loops of a file, multiplied, are bounded: so they are also where
## loops stand in one another or in functions that are called from loops.

## Rounds of all loops of a file, multiplied.
const MAX_ROUNDS: int = 4096
## Elements of an array.
const MAX_ELEMENTS: int = 256
## Tokens of a loop's head: for ( int i = 0 ; i < 8 ; i ++ )
const HEAD: int = 14

const _ASSIGNING: PackedStringArray = [
	"=", "+=", "-=", "*=", "/=", "%=", "&=", "|=", "^=", "<<=", ">>=", "++", "--"
]

var problems: Array[EffectProblem] = []

var _tokens: EffectTokens = null
## Product of the rounds of the loops so far.
var _rounds: int = 1
## Names of constants: an array's length must not be one.
var _constants: Dictionary[String, bool] = {}


static func check(p_tokens: EffectTokens) -> Array[EffectProblem]:
	var rule: LoopRule = LoopRule.new()
	rule._tokens = p_tokens
	rule._check()
	return rule.problems


## Rounds of the loop whose [code]for[/code] stands at an index; 0 if it is not written as it must.
static func rounds_at(p_tokens: EffectTokens, p_for: int) -> int:
	var name: String = p_tokens.at(p_for + 3)
	var head: PackedStringArray = p_tokens.words.slice(p_for, p_for + HEAD)
	var from: String = p_tokens.at(p_for + 5)
	var to: String = p_tokens.at(p_for + 9)
	var wanted: PackedStringArray = [
		"for", "(", "int", name, "=", from, ";", name, "<", to, ";", name, "++", ")"
	]
	if head != wanted or not _is_whole(from) or not _is_whole(to):
		return 0
	return maxi(to.to_int() - from.to_int(), 1)


static func _is_whole(p_token: String) -> bool:
	if p_token.length() > 6:
		return false
	for i: int in p_token.length():
		if p_token.unicode_at(i) < 48 or p_token.unicode_at(i) > 57:
			return false
	return p_token != ""


func _check() -> void:
	var has_loop: bool = false
	for i: int in _tokens.marks:
		if _has_enough():
			return
		match _tokens.words[i]:
			"#", "@":
				_problem(i, "'%s' is not allowed outside of comments." % _tokens.at(i))
			"while", "do":
				_problem(
					i, "'%s' is not allowed: write for (int i = 0; i < 8; i++) { }." % _tokens.at(i)
				)
			"for":
				has_loop = true
				_check_loop(i)
			"const":
				_note_constants(i)
			"[":
				_check_array(i)
			"struct":
				_check_struct(i)
	if has_loop:
		_check_arguments()


## Whether the list of problems is full.
func _has_enough() -> bool:
	return problems.size() >= EffectLimits.MAX_PROBLEMS


func _problem(p_index: int, p_text: String) -> void:
	problems.append(EffectProblem.new(_tokens.line(p_index), p_text))


func _check_loop(p_for: int) -> void:
	var rounds: int = rounds_at(_tokens, p_for)
	if rounds == 0:
		_problem(p_for, "A loop reads for (int i = 0; i < 8; i++) { }, with numbers.")
		return
	if _tokens.at(p_for + HEAD) != "{":
		_problem(p_for, "What a loop repeats stands between { and }.")
		return
	if _rounds * rounds > MAX_ROUNDS:
		_problem(
			p_for,
			(
				"All loops of the file, multiplied, make %d rounds; %d are allowed."
				% [_rounds * rounds, MAX_ROUNDS]
			)
		)
		return
	_rounds *= rounds
	_check_counter(p_for)


## Nothing in the loop but its head may change the counter.
func _check_counter(p_for: int) -> void:
	var name: String = _tokens.at(p_for + 3)
	var end: int = _tokens.closing(p_for + HEAD)
	if end < 0:
		_problem(p_for, "The { of this loop has no }.")
		return
	for i: int in range(p_for + HEAD, end):
		if _tokens.words[i] == name and _is_changed(i):
			_problem(i, "'%s' counts the loop's rounds: nothing else may change it." % name)
			return


func _is_changed(p_index: int) -> bool:
	var after: int = p_index + 1
	while _tokens.at(after) == ")":
		after += 1
	var before: int = p_index - 1
	while _tokens.at(before) == "(":
		before -= 1
	return _ASSIGNING.has(_tokens.at(after)) or ["++", "--"].has(_tokens.at(before))


## A function that may write into its argument could change a counter.
func _check_arguments() -> void:
	for i: int in _tokens.marks:
		if _has_enough():
			return
		if _tokens.words[i] != "inout" and _tokens.words[i] != "out":
			continue
		var type: int = i + 1
		while ["lowp", "mediump", "highp"].has(_tokens.at(type)):
			type += 1
		if _tokens.at(type) == "int":
			_problem(
				i, "A file with loops has no '%s int': it could change a counter." % _tokens.at(i)
			)


func _note_constants(p_const: int) -> void:
	var i: int = p_const + 1
	# The next const is noted by itself: the text is gone through once, however many there are.
	while i < _tokens.size() and not [";", "const"].has(_tokens.words[i]):
		if _tokens.words[i] == "{" and _tokens.at(i - 1) == ")":
			# It was an argument, and here begins the function.
			return
		if _tokens.at(i + 1) == "=":
			_constants[_tokens.words[i]] = true
		i += 1


## The length of an array is a number. Where it could be one, nothing else that is constant is let
## through; a place in an array is something that changes, or a number too.
func _check_array(p_open: int) -> void:
	var end: int = _tokens.closing(p_open)
	if end < 0:
		_problem(p_open, "This [ has no ].")
		return
	var changes: bool = false
	for i: int in range(p_open + 1, end):
		if _tokens.is_word(i) and not _constants.has(_tokens.words[i]):
			changes = changes or not ["int", "uint"].has(_tokens.words[i])
	if end == p_open + 1 or changes:
		return
	var number: String = _tokens.at(p_open + 1)
	if end != p_open + 2 or not _is_whole(number) or number.to_int() > MAX_ELEMENTS:
		_problem(p_open, "Between [ and ] stands a number up to %d." % MAX_ELEMENTS)


## Arrays in structures in arrays would multiply.
func _check_struct(p_struct: int) -> void:
	var open: int = p_struct + 2
	if _tokens.at(open) != "{":
		return
	for i: int in range(open, maxi(_tokens.closing(open), open)):
		if _tokens.words[i] == "[":
			_problem(i, "A struct has no arrays.")
			return
