extends RefCounted
## Ends the process, by name of the test, when a test blocks the main thread for too long.
##
## A test that awaits is stopped by the runner itself; one that loops without awaiting never gives
## the runner the word again. A thread of its own watches the clock instead.

var _mutex: Mutex = Mutex.new()
var _thread: Thread = Thread.new()
var _test: String = ""
var _deadline_ms: int = 0
var _stopping: bool = false


## Starts to watch.
func start() -> void:
	_thread.start(_watch)


## Watches a test, which has to be over within [param p_limit] s.
func begin(p_test: String, p_limit: float) -> void:
	_mutex.lock()
	_test = p_test
	_deadline_ms = Time.get_ticks_msec() + int(p_limit * 1000.0)
	_mutex.unlock()


## The test is over.
func end() -> void:
	begin("", 0.0)


## Stops to watch.
func stop() -> void:
	_mutex.lock()
	_stopping = true
	_mutex.unlock()
	_thread.wait_to_finish()


func _watch() -> void:
	while true:
		OS.delay_msec(50)
		_mutex.lock()
		var stopping: bool = _stopping
		var test: String = _test
		var late: bool = not test.is_empty() and Time.get_ticks_msec() > _deadline_ms
		_mutex.unlock()
		if stopping:
			return
		if late:
			print("FAIL %s  blocks the main thread; the run ends here" % test)
			printerr("test runner: %s hangs, process killed" % test)
			OS.kill(OS.get_process_id())
			return
