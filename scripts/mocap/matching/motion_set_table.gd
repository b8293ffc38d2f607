class_name MotionSetTable
extends RefCounted
## What a motion set is made of: a text file, one clip a line.
##
## [codeblock lang=text]
## # file      stance  from_s  to_s  name
## 02_01.bvh   stand   0.2     2.6   walk 1.2
## [/codeblock]
## Files are named from the folder of the table, or from the one that is given. Times are of the
## clip as it is played, s; a to_s of 0 is its end. A file that ends in [code].motionset[/code] is
## another set, of which the clip of that stance and name is taken as it is.

## Names of the stances.
const STANCES: Dictionary[String, MotionMatcher.Stance] = {
	"stand": MotionMatcher.STAND,
	"crouch": MotionMatcher.CROUCH,
	"prone": MotionMatcher.PRONE,
	"ladder": MotionMatcher.LADDER,
	"vault": MotionMatcher.VAULT,
}
## How the file of a set ends.
const SET_EXTENSION: String = "motionset"
## Longest clip, s: what is longer is no clip.
const MAX_S: float = 600.0


## A line of the table.
class Row:
	extends RefCounted

	## Name of the motion file.
	var file: String = ""
	## One of [enum MotionMatcher.Stance].
	var stance: MotionMatcher.Stance = MotionMatcher.STAND
	## Where the clip begins and ends, s; an end of 0 is the file's.
	var from_s: float = 0.0
	var to_s: float = 0.0
	## What it is called in the set.
	var name: String = ""

	## The line.
	func describe() -> String:
		var parts: Array = [file, STANCES.find_key(stance), from_s, to_s, name]
		return "%s %s %.3f %.3f %s" % parts


## The lines that are clips.
var rows: Array[Row] = []
## What is wrong with the table, or an empty text.
var error: String = ""


## Reads the text of a table; [param p_source] is its name in errors.
static func parse(p_text: String, p_source: String) -> MotionSetTable:
	var table: MotionSetTable = MotionSetTable.new()
	var number: int = 0
	for line: String in p_text.split("\n"):
		number += 1
		var words: PackedStringArray = line.get_slice("#", 0).replace("\t", " ").split(" ", false)
		if words.is_empty():
			continue
		var fault: String = table._read(words)
		if fault != "":
			table.error = "%s:%d: %s" % [p_source, number, fault]
			return table
	if table.rows.is_empty():
		table.error = "%s: no clips" % p_source
	return table


func _read(p_words: PackedStringArray) -> String:
	if p_words.size() < 5:
		return "expected: FILE STANCE FROM_S TO_S NAME"
	var row: Row = Row.new()
	row.file = p_words[0]
	if not STANCES.has(p_words[1]):
		return "a stance is %s; found '%s'" % [", ".join(STANCES.keys()), p_words[1]]
	row.stance = STANCES[p_words[1]]
	for word: String in [p_words[2], p_words[3]]:
		if not word.is_valid_float() or not (word.to_float() >= 0.0 and word.to_float() <= MAX_S):
			return "a time is 0 to %d s; found '%s'" % [MAX_S, word]
	row.from_s = p_words[2].to_float()
	row.to_s = p_words[3].to_float()
	row.name = " ".join(p_words.slice(4))
	rows.append(row)
	return ""
