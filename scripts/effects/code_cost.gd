@tool
class_name CodeCost
extends RefCounted
## How much work an effect's code is, counted before anything runs: tokens, with what loops repeat
## and called functions add. Far too costly code hangs a picture as an endless loop does.

## Work of a particle in a frame, tokens.
const MAX_WORK: int = 100000
## Work of all particles in a frame, tokens. Measured with software rendering: about 1 ns a token.
const MAX_TOTAL: int = 60000000
## What a driver has to compile, with every called function written out, tokens. Measured where the
## processor draws: up to 0.25 ms a token, and the picture stands still meanwhile.
const MAX_WRITTEN_OUT: int = 3500
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

const _OPENING: Dictionary[String, String] = {"(": ")", "[": "]", "{": "}"}
const _CLOSING: Dictionary[String, String] = {")": "(", "]": "[", "}": "{"}

var problems: Array[EffectProblem] = []
## Whether brackets fit together and nothing is too deep or too long; else only that is said.
var is_well_formed: bool = false
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
			EffectProblem.new(
				1, "An effect has at most %d words and signs." % EffectTokens.MAX_TOKENS
			)
		)
		return cost
	cost._check_shape()
	cost.is_well_formed = cost.problems.is_empty()
	if cost.is_well_formed:
		cost._find_functions()
		cost._measure()
	return cost


## Adds a problem if so many particles would take too long.
func check_count(p_count: int, p_preprocess: float) -> void:
	if not problems.is_empty():
		return
	var steps: int = 1 + int(p_preprocess * STEPS_PER_SECOND / 10.0)
	if p_count * work * steps > MAX_TOTAL:
		(
			problems
			. append(
				(
					EffectProblem
					. new(
						1,
						(
							(
								"%d particles of %d steps each are too much work for a frame (%d times too much): "
								% [p_count, work, ceili(float(p_count * work * steps) / MAX_TOTAL)]
							)
							+ "fewer particles, fewer rounds of loops, or less @preprocess."
						)
					)
				)
			)
		)


## Brackets fit together, and nothing is so deep that a compiler runs out of its stack.
func _check_shape() -> void:
	var open: PackedInt32Array = []
	var statement: int = 0
	var elses: int = 0
	for i: int in _tokens.marks:
		var token: String = _tokens.words[i]
		if _OPENING.has(token):
			open.append(i)
		elif _CLOSING.has(token):
			if open.is_empty() or _tokens.words[open[-1]] != _CLOSING[token]:
				_problem_of_bracket(i, open)
				return
			open.remove_at(open.size() - 1)
		elif token == ";" and not open.is_empty() and _is_unclosed(open[-1]):
			_problem_of_bracket(i, open)
			return
		elif token == "else":
			elses += 1
		if open.size() > MAX_DEPTH or elses > MAX_ELSE:
			_problem(i, "Too much stands in one another: cut it into functions.")
			return
		if token == ";" or token == "{" or token == "}":
			if i - statement > MAX_STATEMENT:
				_problem(i, "This statement is too long: cut it into several.")
				return
			statement = i
	if not open.is_empty():
		_problem_of_bracket(_tokens.size() - 1, open)
	elif _tokens.size() - statement > MAX_STATEMENT:
		_problem(statement, "This statement is too long: cut it into several.")


## Whether a ; inside of this bracket is a mistake: it is none in the head of a loop.
func _is_unclosed(p_open: int) -> bool:
	return _tokens.words[p_open] != "{" and _tokens.at(p_open - 1) != "for"


func _problem_of_bracket(p_index: int, p_open: PackedInt32Array) -> void:
	if p_open.is_empty():
		_problem(p_index, "This %s closes nothing." % _tokens.at(p_index))
		return
	var open: int = p_open[-1]
	_problem(open, "The %s has no %s." % [_tokens.at(open), _OPENING[_tokens.at(open)]])


func _problem(p_index: int, p_text: String) -> void:
	problems.append(EffectProblem.new(_tokens.line(p_index), p_text))


## A function is a name, arguments in brackets and a body, outside of all other braces.
func _find_functions() -> void:
	var depth: int = 0
	var arguments: int = 0
	for i: int in _tokens.marks:
		match _tokens.words[i]:
			"(":
				arguments = i if depth == 0 else arguments
			"{":
				if depth == 0 and _tokens.at(i - 1) == ")":
					_bodies[i] = _tokens.at(arguments - 1)
					_functions[_bodies[i]] = true
				depth += 1
			"}":
				depth -= 1


func _measure() -> void:
	var body: int = -1
	var depth: int = 0
	for place: int in _tokens.marks.size():
		var i: int = _tokens.marks[place]
		if _tokens.words[i] == "{":
			body = place if depth == 0 else body
			depth += 1
		elif _tokens.words[i] == "}":
			depth -= 1
			if depth == 0 and _bodies.has(_tokens.marks[body]):
				_measure_body(_bodies[_tokens.marks[body]], body, place)
				if not problems.is_empty():
					return
	work = maxi(_work.get("process", 0), _work.get("start", 0))


## The body of a function from one mark to another.
func _measure_body(p_name: String, p_from: int, p_to: int) -> void:
	var total: int = 0
	var written: int = 0
	var rounds: int = 1
	var outer: PackedInt32Array = []
	var next_rounds: int = 1
	var last: int = _tokens.marks[p_from] - 1
	for place: int in range(p_from, p_to + 1):
		var i: int = _tokens.marks[place]
		total += rounds * (i - last)
		written += i - last
		last = i
		match _tokens.words[i]:
			"for":
				next_rounds = maxi(LoopRule.rounds_at(_tokens, i), 1)
			"{":
				outer.append(rounds)
				rounds *= next_rounds
				next_rounds = 1
			"}":
				rounds = outer[-1]
				outer.remove_at(outer.size() - 1)
			"(":
				var called: String = _tokens.at(i - 1)
				if _functions.has(called) and not _work.has(called):
					_problem(i, "A function stands above where it is used: '%s'." % called)
					return
				total += rounds * _work.get(called, HELPER_WORK)
				written += _written_out.get(called, HELPER_WORK)
		if written > MAX_WRITTEN_OUT:
			_problem(i, "'%s' is too long, with all that it calls." % p_name)
			return
		if total > MAX_WORK:
			_problem(i, "'%s' is too much work for each particle: %d steps." % [p_name, total])
			return
	# Of functions with one name the dearest counts.
	_work[p_name] = maxi(_work.get(p_name, 0), total)
	_written_out[p_name] = maxi(_written_out.get(p_name, 0), written)
