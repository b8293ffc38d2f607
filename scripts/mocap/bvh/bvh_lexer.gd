class_name BvhLexer
extends RefCounted
## Splits the text of a BVH file into lines and words, and keeps track of the line.
##
## A comment runs from [code]#[/code] or [code]//[/code], at the start of a line or after a space,
## to the end of the line. Braces are words of their own even when nothing separates them.

## Longest quote of the file in an error, characters.
const MAX_QUOTE: int = 60

## The first error, or an empty text.
var error: String = ""

var _source: String = ""
var _lines: PackedStringArray = PackedStringArray()
var _line: int = -1
var _words: PackedStringArray = PackedStringArray()
var _word: int = 0
var _comment: RegEx = RegEx.create_from_string("(^|\\s)(#|//).*$")


## Takes the file's whole text; [param p_source] is its name in errors.
func _init(p_text: String, p_source: String) -> void:
	_source = p_source
	var text: String = p_text.trim_prefix("\ufeff").replace("\r\n", "\n").replace("\r", "\n")
	_lines = text.replace("\t", " ").trim_suffix("\n").split("\n")


## The next word without taking it, or an empty text at the end of the file.
func peek() -> String:
	while _word >= _words.size():
		if not next_line():
			return ""
	return _words[_word]


## Takes the next word; an empty text at the end of the file.
func take() -> String:
	var word: String = peek()
	_word += 1
	return word


## Takes the next word if it is [param p_keyword] in any case.
func take_keyword(p_keyword: String) -> bool:
	if peek().to_upper() != p_keyword:
		return false
	_word += 1
	return true


## Takes the words up to the end of the line or the next brace, joined by single spaces.
func take_name() -> String:
	var parts: PackedStringArray = PackedStringArray()
	while not is_line_done() and not _words[_word] in ["{", "}"]:
		parts.append(_words[_word])
		_word += 1
	return " ".join(parts)


## Whether no words are left in this line.
func is_line_done() -> bool:
	return _word >= _words.size()


## Moves to the next line, and splits it. Returns false at the end of the file.
func next_line() -> bool:
	if _line + 1 >= _lines.size():
		_line = maxi(_lines.size() - 1, 0)
		_words = PackedStringArray()
		_word = 0
		return false
	_line += 1
	var text: String = clean_line(_line)
	if text.contains("{") or text.contains("}"):
		text = text.replace("{", " { ").replace("}", " } ")
	_words = text.split(" ", false)
	_word = 0
	return true


## Number of lines in the file.
func line_count() -> int:
	return _lines.size()


## Index of the current line, from 0.
func line_index() -> int:
	return _line


## A line by its index, tabs being spaces.
func raw_line(p_index: int) -> String:
	return _lines[p_index]


## A line by its index without comments and outer spaces.
func clean_line(p_index: int) -> String:
	var text: String = _lines[p_index]
	if text.contains("#") or text.contains("//"):
		text = _comment.sub(text, "")
	return text.strip_edges()


## Reports that [param p_wanted] was expected instead of the next word.
func fail_at_next(p_wanted: String) -> bool:
	var word: String = peek()
	return fail_at(_line, "expected %s, found %s" % [p_wanted, quote(word)])


## Reports an error in the line with that index, from 0. The first one stays. Returns false.
func fail_at(p_index: int, p_message: String) -> bool:
	if error.is_empty():
		error = locate(p_index, p_message)
	return false


## A message with the file and the line, whose index is from 0, before it.
func locate(p_index: int, p_message: String) -> String:
	return "%s:%d: %s" % [_source, maxi(p_index, 0) + 1, p_message]


## A piece of the file for an error: in quotes, short, without control characters.
static func quote(p_text: String) -> String:
	if p_text.is_empty():
		return "the end of the file"
	var text: String = p_text.left(MAX_QUOTE)
	var shown: String = ""
	for letter: String in text:
		shown += letter if letter.unicode_at(0) >= 32 and letter.unicode_at(0) != 127 else "?"
	return "'%s%s'" % [shown, "..." if p_text.length() > MAX_QUOTE else ""]
