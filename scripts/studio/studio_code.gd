@tool
class_name StudioCode
extends CodeEdit
## The code of an effect: colours, completion, help for the word at the caret or under the mouse,
## and its problems at their lines.

## What the word at the caret or under the mouse means; empty if that is not known.
signal help_changed(p_text: String)

const COLOUR_KEYWORD: Color = Color(1.0, 0.44, 0.52)
const COLOUR_TYPE: Color = Color(0.26, 1.0, 0.76)
const COLOUR_BUILT_IN: Color = Color(1.0, 0.85, 0.4)
const COLOUR_HELPER: Color = Color(0.5, 0.85, 1.0)
const COLOUR_SETTING: Color = Color(0.95, 0.65, 0.95)
const COLOUR_COMMENT: Color = Color(0.6, 0.64, 0.68)
const COLOUR_PROBLEM: Color = Color(0.6, 0.1, 0.1, 0.5)

const _LETTERS: String = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ_"

## Names that the file itself declares, offered as completions.
var own_names: PackedStringArray = []

var _marked: PackedInt32Array = []


func _init() -> void:
	syntax_highlighter = _make_highlighter()
	gutters_draw_line_numbers = true
	indent_automatic = true
	auto_brace_completion_enabled = true
	highlight_current_line = true
	highlight_all_occurrences = true
	scroll_smooth = true
	code_completion_enabled = true
	var prefixes: Array[String] = ["@"]
	for letter: String in _LETTERS:
		prefixes.append(letter)
	code_completion_prefixes = prefixes
	code_completion_requested.connect(_complete)
	caret_changed.connect(_on_caret_changed)
	var font: SystemFont = SystemFont.new()
	font.font_names = ["monospace"]
	add_theme_font_override("font", font)
	add_theme_font_size_override("font_size", 13)
	symbol_tooltip_on_hover = true
	symbol_hovered.connect(_on_hovered)


## Shows problems at their lines; none takes the marks away.
func show_problems(p_problems: Array[EffectProblem]) -> void:
	for line: int in _marked:
		if line < get_line_count():
			set_line_background_color(line, Color(0.0, 0.0, 0.0, 0.0))
	_marked.clear()
	for problem: EffectProblem in p_problems:
		var line: int = clampi(problem.line - 1, 0, get_line_count() - 1)
		set_line_background_color(line, COLOUR_PROBLEM)
		_marked.append(line)


## Puts another text in without losing undo: what was there comes back by Ctrl+Z.
func replace_text(p_text: String) -> void:
	if p_text == text:
		return
	var line: int = get_caret_line()
	var column: int = get_caret_column()
	begin_complex_operation()
	select_all()
	insert_text_at_caret(p_text)
	end_complex_operation()
	set_caret_line(mini(line, get_line_count() - 1))
	set_caret_column(column)


static func _make_highlighter() -> CodeHighlighter:
	var made: CodeHighlighter = CodeHighlighter.new()
	made.number_color = Color(0.65, 0.85, 1.0)
	made.symbol_color = Color(0.67, 0.79, 1.0)
	made.function_color = Color(0.34, 0.7, 1.0)
	made.member_variable_color = Color(0.74, 0.88, 1.0)
	var groups: Dictionary[Color, Dictionary] = {
		COLOUR_KEYWORD: StudioWords.KEYWORDS,
		COLOUR_TYPE: StudioWords.TYPES,
		COLOUR_BUILT_IN: StudioWords.BUILT_IN,
		COLOUR_HELPER: StudioWords.HELPERS,
	}
	for colour: Color in groups:
		for word: String in groups[colour]:
			made.add_keyword_color(word, colour)
	made.add_color_region("// @", "", COLOUR_SETTING, true)
	made.add_color_region("//", "", COLOUR_COMMENT, true)
	made.add_color_region("/*", "*/", COLOUR_COMMENT, false)
	return made


func _complete() -> void:
	if get_line(get_caret_line()).strip_edges().begins_with("// @"):
		_complete_setting()
	else:
		var kinds: Dictionary[CodeCompletionKind, Dictionary] = {
			KIND_PLAIN_TEXT: StudioWords.KEYWORDS,
			KIND_CLASS: StudioWords.TYPES,
			KIND_CONSTANT: StudioWords.BUILT_IN,
		}
		for kind: CodeCompletionKind in kinds:
			for word: String in kinds[kind]:
				add_code_completion_option(kind, word, word)
		for words: Dictionary[String, String] in [StudioWords.HELPERS, StudioWords.FUNCTIONS]:
			for word: String in words:
				var call: String = word if word == "wind" else word + "("
				add_code_completion_option(KIND_FUNCTION, word, call)
		for word: String in own_names:
			add_code_completion_option(KIND_VARIABLE, word, word)
	update_code_completion_options(false)


func _complete_setting() -> void:
	var words: PackedStringArray = get_line(get_caret_line()).strip_edges().substr(4).split(
		" ", false
	)
	var key: EffectKey = EffectSettings.keys().get(words[0]) if not words.is_empty() else null
	if key != null and not key.choices.is_empty():
		for choice: String in key.choices:
			add_code_completion_option(KIND_CONSTANT, choice, choice)
		return
	for name: String in EffectSettings.keys():
		add_code_completion_option(KIND_MEMBER, name, name + " ")


func _on_caret_changed() -> void:
	_tell(get_word_under_caret(), get_caret_line())


func _on_hovered(p_symbol: String, p_line: int, _p_column: int) -> void:
	_tell(p_symbol, p_line)
	set_tooltip_text(StudioWords.meaning(p_symbol, _is_setting(p_line)))


func _tell(p_word: String, p_line: int) -> void:
	var is_setting: bool = _is_setting(p_line)
	var word: String = p_word
	if is_setting:
		var words: PackedStringArray = get_line(p_line).strip_edges().substr(4).split(" ", false)
		word = words[0] if not words.is_empty() else ""
	var meaning: String = StudioWords.meaning(word, is_setting)
	if meaning != "":
		help_changed.emit(meaning if is_setting else "%s: %s" % [word, meaning])


func _is_setting(p_line: int) -> bool:
	return get_line(p_line).strip_edges().begins_with("// @")
