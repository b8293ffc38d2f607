class_name RpcErrorLimiter
extends Logger
## Counts the engine's errors that clients' remote calls cause, so that their senders can be
## disconnected before the log fills.
##
## Godot reports an error for each call with an unknown node or method or wrong arguments; this
## cannot be checked beforehand.

## Errors that a client may cause.
const MAX_STRIKES: int = 3

var _mutex: Mutex = Mutex.new()
var _peer: ThreadedPeer = null
var _counting: bool = false
var _strikes: Dictionary[int, int] = {}


func _init(p_peer: ThreadedPeer) -> void:
	_peer = p_peer


## Counts from now on; call it in the main thread.
func begin() -> void:
	_mutex.lock()
	_counting = true
	_mutex.unlock()


## Stops counting. Returns the peers that have caused too many errors.
func end() -> Array[int]:
	var guilty: Array[int] = []
	_mutex.lock()
	_counting = false
	for peer: int in _strikes:
		if not _peer.has_peer(peer):
			_strikes[peer] = 0
		elif _strikes[peer] >= MAX_STRIKES:
			guilty.append(peer)
			_strikes[peer] = 0
	_mutex.unlock()
	return guilty


func _log_error(
	_p_function: String,
	_p_file: String,
	_p_line: int,
	_p_code: String,
	_p_rationale: String,
	_p_editor_notify: bool,
	_p_error_type: int,
	_p_script_backtraces: Array[ScriptBacktrace]
) -> void:
	if OS.get_thread_caller_id() != OS.get_main_thread_id():
		return
	_mutex.lock()
	if _counting and _peer.reading_call_of > 0:
		_strikes[_peer.reading_call_of] = _strikes.get(_peer.reading_call_of, 0) + 1
	_mutex.unlock()
