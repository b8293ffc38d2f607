extends TestCase
## What is said of a runtime that gives no headset, and the way back to one.

var _manifest: RuntimeManifest = RuntimeManifest.new()
var _way: HmdReturn = null


func before_each() -> void:
	_way = HmdReturn.new(HmdCommand.of("/nonexistent/game", [], "/"))
	_manifest.path = "/etc/runtime.json"
	_manifest.library = "/lib/libxr.so"


func after_each() -> void:
	OS.unset_environment("XR_RUNTIME_JSON")


func test_every_answer_says_what_to_do() -> void:
	equal(HmdReturn.explain(RuntimeProbe.READY, _manifest), "")
	is_true("/lib/libxr.so" in HmdReturn.explain(RuntimeProbe.NO_LIBRARY, _manifest))
	is_true("start it" in HmdReturn.explain(RuntimeProbe.NO_SERVICE, _manifest))
	is_true("plug it in" in HmdReturn.explain(RuntimeProbe.NO_HEADSET, _manifest))
	is_true("start it again" in HmdReturn.explain(RuntimeProbe.STALLED, _manifest))


func test_without_a_runtime_nothing_is_started() -> void:
	OS.set_environment("XR_RUNTIME_JSON", "/nonexistent/runtime.json")
	is_true("/nonexistent/runtime.json is not there" in _way.ask())
	for i: int in 100:
		is_false(_way.advance(0.5))
