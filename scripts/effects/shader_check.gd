@tool
class_name ShaderCheck
extends RefCounted
## Compiles the text of an effect beside what is shown, headless too, and says what is wrong with it
## by line. What has no problems may be shown.


## The problems of a file, those of its header and loops first; empty if it may be shown.
##
## [param p_quietly]: the engine writes what it finds into the log. Quietly, it does not, and the
## only problem is then that the code does not compile: for texts that anybody can send often.
static func problems(p_file: EffectFile, p_quietly: bool = false) -> Array[EffectProblem]:
	var found: Array[EffectProblem] = p_file.problems.duplicate()
	if not found.is_empty():
		return found
	var shader: Shader = Shader.new()
	var errors: CompilerErrors = CompilerErrors.new()
	var was_printing: bool = Engine.print_to_stdout
	var prints_errors: bool = Engine.print_error_messages
	Engine.print_to_stdout = false
	Engine.print_error_messages = prints_errors and not p_quietly
	OS.add_logger(errors)
	shader.code = p_file.code()
	var compiled: bool = _is_compiled(shader)
	OS.remove_logger(errors)
	Engine.print_error_messages = prints_errors
	Engine.print_to_stdout = was_printing
	if compiled:
		return found
	for problem: EffectProblem in errors.found:
		found.append(CompilerWords.explain(problem, p_file))
	if found.is_empty():
		found.append(EffectProblem.new(1, "The code does not compile."))
	return found


static func _is_compiled(p_shader: Shader) -> bool:
	if p_shader.get_mode() != Shader.MODE_PARTICLES:
		return false
	for uniform: Dictionary in p_shader.get_shader_uniform_list():
		if uniform["name"] == EffectFile.MARK:
			return true
	return false


## Hears what the compiler says while it works. It may speak from another thread.
class CompilerErrors:
	extends Logger

	var found: Array[EffectProblem] = []

	var _mutex: Mutex = Mutex.new()

	func _log_error(
		_function: String,
		_file: String,
		p_line: int,
		p_code: String,
		p_rationale: String,
		_editor_notify: bool,
		p_type: int,
		_backtraces: Array[ScriptBacktrace]
	) -> void:
		if p_type != ERROR_TYPE_SHADER:
			return
		_mutex.lock()
		if found.size() < EffectLimits.MAX_PROBLEMS:
			found.append(EffectProblem.new(p_line, p_rationale if p_rationale != "" else p_code))
		_mutex.unlock()
