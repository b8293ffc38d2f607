class_name CodeCost
extends RefCounted
## How much work an effect's code is, counted before anything runs: tokens, with what loops repeat
## and called functions add. Far too costly code hangs a picture as an endless loop does.

## Work of a particle in a frame, tokens.
const MAX_WORK: int = 100000
## Work of all particles in a frame, tokens. Measured with software rendering: about 1 ns a token.
const MAX_TOTAL: int = 60000000
## What a driver has to compile, with every called function written out, tokens.
const MAX_WRITTEN_OUT: int = 12000
## Brackets in brackets: compilers call themselves for each.
const MAX_DEPTH: int = 40
## Tokens between two of ; { and }: a long chain of signs is as deep as it is long.
const MAX_STATEMENT: int = 400
## An else if stands in the else before it.
const MAX_ELSE: int = 100
## What a call of one of the helpers adds, tokens.
const HELPER_WORK: int = 15
## Steps of a second that are made up for by [code]@preprocess[/code].
const STEPS_PER_SECOND: int = 60

var problems: Array[EffectProblem] = []
## Of a particle in a frame: the larger of start() and process(), tokens.
var work: int = 0

var _tokens: EffectTokens = null
var _work: Dictionary[String, int] = {}
var _written_out: Dictionary[String, int] = {}
## The functions of the file, those below too.
var _functions: Dictionary[String, bool] = {}
## Where { of a function's body stands, and its name.
var _bodies: Dictionary[int, String] = {}


static func measure(p_tokens: EffectTokens) -> CodeCost:
	var cost: CodeCost = CodeCost.new()
	cost._tokens = p_tokens
	if p_tokens.too_many:
		cost.problems.append(
			EffectProblem.new(1, "An effect has at most %d words and signs." % EffectTokens.MAX_TOKENS)
		)
		return cost
	cost._check_shape()
	if cost.problems.is_empty():
		cost._find_functions()
		cost._measure()
	return cost


## Adds a problem if so many particles would take too long.
func check_count(p_count: int, p_preprocess: float) -> void:
	if not problems.is_empty():
		return
	var steps: int = 1 + int(p_preprocess * STEPS_PER_SECOND / 10.0)
	if p_count * work * steps > MAX_TOTAL:
		problems.append(
			EffectProblem.new(
				1,
				(
					"%d particles of %d steps each are too much work for a frame (%d times too much): "
					% [p_count, work, ceili(float(p_count * work * steps) / MAX_TOTAL)]
					+ "fewer particles, fewer rounds of loops, or less @preprocess."
				)
			)
		)


func _check_shape() -> void:
	var depth: int = 0
	var since: int = 0
	var elses: int = 0
	for i: int in _tokens.size():
		since += 1
		match _tokens.words[i]:
			"(", "[", "{":
				depth += 1
			")", "]", "}":
				depth -= 1
			"else":
				elses += 1
		if [";", "{", "}"].has(_tokens.words[i]):
			since = 0
		if depth > MAX_DEPTH:
			_problem(i, "There are more than %d brackets in one another." % MAX_DEPTH)
			return
		if since > MAX_STATEMENT:
			_problem(i, "This statement is too long: cut it into several.")
			return
	if elses > MAX_ELSE:
		_problem(0, "There are more than %d 'else'." % MAX_ELSE)


func _problem(p_index: int, p_text: String) -> void:
	problems.append(EffectProblem.new(_tokens.line(p_index), p_text))


## A function is a name, arguments in brackets and a body, outside of all other braces.
func _find_functions() -> void:
	var depth: int = 0
	for i: int in _tokens.size():
		match _tokens.words[i]:
			"{":
				if depth == 0 and _tokens.at(i - 1) == ")":
					var open: int = _opening(i - 1)
					_bodies[i] = _tokens.at(open - 1)
					_functions[_bodies[i]] = true
				depth += 1
			"}":
				depth -= 1


func _opening(p_close: int) -> int:
	var i: int = p_close
	while i > 0 and _tokens.words[i] != "(":
		i -= 1
	return i


func _measure() -> void:
	for open: int in _bodies:
		var end: int = _tokens.closing(open)
		if end < 0:
			_problem(open, "The { of '%s' has no }." % _bodies[open])
			return
		_measure_body(_bodies[open], open, end)
		if not problems.is_empty():
			return
	work = maxi(_work.get("process", 0), _work.get("start", 0))


func _measure_body(p_name: String, p_open: int, p_end: int) -> void:
	var total: int = 0
	var written: int = 0
	var rounds: int = 1
	var outer: PackedInt32Array = []
	var next_rounds: int = 1
	for i: int in range(p_open, p_end + 1):
		var token: String = _tokens.words[i]
		match token:
			"for":
				next_rounds = maxi(LoopRule.rounds_at(_tokens, i), 1)
			"{":
				outer.append(rounds)
				rounds *= next_rounds
				next_rounds = 1
			"}":
				rounds = outer[-1]
				outer.remove_at(outer.size() - 1)
		total += rounds
		written += 1
		if _tokens.at(i + 1) != "(":
			continue
		if _functions.has(token) and not _work.has(token):
			_problem(i, "'%s' stands below here: a function stands above where it is used." % token)
			return
		total += rounds * _work.get(token, HELPER_WORK)
		written += _written_out.get(token, HELPER_WORK)
		if total > MAX_WORK or written > MAX_WRITTEN_OUT:
			_problem(i, "'%s' is too much work for each particle: %d steps." % [p_name, total])
			return
	# Of functions with one name the dearest counts.
	_work[p_name] = maxi(_work.get(p_name, 0), total)
	_written_out[p_name] = maxi(_written_out.get(p_name, 0), written)
